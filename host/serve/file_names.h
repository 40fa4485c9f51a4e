#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// The name of a file as users see it. The bytes are kept under a number: no name ever reaches the
/// file system.
///
/// One segment of valid UTF-8, at most 200 bytes, no control characters, no slashes, no dot in
/// front, and an extension of something that can be printed.
class FileName {
 public:
  static constexpr std::size_t kSizeMax = 200;

  /// \return kInput with what is wrong.
  [[nodiscard]] static Result<FileName> from(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// In lower case, with its dot.
  [[nodiscard]] const std::string& extension() const { return extension_; }
  [[nodiscard]] bool is_gcode() const;

 private:
  FileName(std::string text, std::string extension)
      : text_(std::move(text)), extension_(std::move(extension)) {}

  std::string text_;
  std::string extension_;
};

/// What stands behind the last slash or backslash: slicers send paths of their own machine.
[[nodiscard]] std::string_view last_segment(std::string_view path);

/// Whether the bytes are UTF-8 as RFC 3629 has it.
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace slipstick
