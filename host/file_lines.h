#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/line_source.h"
#include "host/status_pace.h"

namespace slipstick {

/// The lines of a G-code file, read as they are needed, whatever ends them (LF, CR LF, CR; the last
/// one nothing), without what floods a display (StatusPace). A line that no printer could take is
/// an error that names file and line.
class FileLines final : public LineSource {
 public:
  /// Bytes; slicers write pictures in comments of some hundred.
  static constexpr std::size_t kMaxLine = 65'536;

  [[nodiscard]] static Result<std::unique_ptr<FileLines>> open(const std::filesystem::path& path);

  /// Reads the file once from end to end, so that nothing is wrong with it when the printer is hot.
  /// \return how many lines it sends. Fails as `open` and `next`.
  [[nodiscard]] static Result<std::int64_t> check(const std::filesystem::path& path);

  /// kUnavailable when the file cannot be read further.
  [[nodiscard]] Result<std::optional<Line>> next() override;
  [[nodiscard]] bool ready() const override { return true; }

 private:
  FileLines(std::filesystem::path path, std::ifstream stream)
      : path_(std::move(path)), stream_(std::move(stream)) {}

  /// The next line that is a command; nothing at the end of the file.
  [[nodiscard]] Result<std::optional<Line>> next_command();
  /// More of the file into `block_`. \return whether there was any.
  [[nodiscard]] bool fill();
  /// The next line into `text_`. \return whether there was one.
  [[nodiscard]] bool read_line();
  [[nodiscard]] std::string here() const;

  std::filesystem::path path_;
  std::ifstream stream_;
  std::string block_;  ///< Of the file, read up to `at_`.
  std::size_t at_ = 0;
  bool after_return_ = false;  ///< A LF would be the second half of a CR LF.
  std::string text_;           ///< At most a byte more than `kMaxLine`.
  std::int64_t number_ = 0;
  StatusPace pace_;
  bool ended_ = false;
};

}  // namespace slipstick
