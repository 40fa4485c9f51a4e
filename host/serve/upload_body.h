#pragma once

#include <optional>

#include "host/serve/http.h"
#include "host/serve/multipart.h"
#include "host/serve/upload_file.h"

namespace slipstick {

/// The body of a request on its way into a file: all of it, or the file of a form.
class UploadBody {
 public:
  /// \param boundary of a form; nothing: the body is the file.
  [[nodiscard]] static Result<UploadBody> create(const std::filesystem::path& path,
                                                 const std::optional<std::string>& boundary);

  /// \return kInput for a form that is none, or a file in it whose name cannot be; kUnavailable,
  /// as on a full disk.
  [[nodiscard]] Result<void> write(std::string_view bytes);
  /// Whether that was for the name.
  [[nodiscard]] bool name_is_wrong() const { return parts_->name_is_wrong; }

  /// After the last byte: everything is on the disk. \return kInput for a form that breaks off.
  [[nodiscard]] Result<HttpUpload> finish();

 private:
  struct Parts {
    explicit Parts(UploadFile made) : file(std::move(made)) {}
    UploadFile file;
    std::string name;
    bool name_is_wrong = false;
    std::map<std::string, std::string> fields;
    std::optional<MultipartParser> parser;
  };
  [[nodiscard]] static Result<void> take_name(Parts& parts, std::string name);
  explicit UploadBody(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

  std::unique_ptr<Parts> parts_;  // stays where it is: the parser writes to it
};

}  // namespace slipstick
