#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// Takes a `multipart/form-data` body (RFC 7578) apart as it comes: fields whole, the one file in
/// pieces. Memory is bounded, whatever comes.
class MultipartParser {
 public:
  static constexpr std::size_t kBoundaryMax = 70;  ///< RFC 2046.
  static constexpr std::size_t kHeadMax = 4 << 10;
  static constexpr std::size_t kFieldMax = 64 << 10;
  static constexpr int kPartsMax = 32;

  struct Sink {
    std::function<void(std::string name, std::string value)> field;
    /// Once, before its bytes: the file's name as the client gives it.
    std::function<Result<void>(std::string name)> file;
    std::function<Result<void>(std::string_view bytes)> bytes;  ///< Of the file.
  };

  /// The boundary in a Content-Type; nothing if that is no form.
  [[nodiscard]] static std::optional<std::string> boundary_of(std::string_view content_type);

  MultipartParser(std::string_view boundary, Sink sink);

  /// The next bytes. \return kInput for what is no form, has too much of something or two files;
  /// or what `Sink::file` or `Sink::bytes` failed with. After that the parser is not to be used.
  [[nodiscard]] Result<void> feed(std::string_view bytes);

  /// Whether the last boundary came.
  [[nodiscard]] bool complete() const { return stage_ == Stage::kOver; }

 private:
  enum class Stage : std::uint8_t { kPreamble, kBoundary, kHead, kField, kFile, kOver };

  /// One step forward; false if more bytes are needed first.
  [[nodiscard]] Result<bool> step();
  [[nodiscard]] Result<bool> take_body();
  [[nodiscard]] Result<void> take(std::string_view bytes);
  [[nodiscard]] bool end_of_boundary();
  [[nodiscard]] Result<bool> take_head();
  [[nodiscard]] Result<void> begin_part(std::string_view head);
  void end_part();

  const std::string delimiter_;  // "\r\n--boundary"
  const Sink sink_;
  Stage stage_ = Stage::kPreamble;
  std::string pending_ = "\r\n";  // the first delimiter may be the first bytes
  std::string name_;
  std::string value_;
  int parts_ = 0;
  bool has_file_ = false;
};

}  // namespace slipstick
