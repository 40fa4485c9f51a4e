#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/result.h"

namespace slipstick {

/// One command that any Marlin takes as it is, whatever number stands before it.
///
/// Marlin keeps 95 bytes of a line and sums what is left after it has dropped comments and escapes;
/// a line that is not like this is refused for ever or, worse, shortened. So: printable ASCII
/// without
/// `*` `;` `\` `"` and brackets, no blank at either end, at most `kMaxText` bytes, and nowhere
/// `M110`, which switches the check of line numbers off even inside a message.
class Line {
 public:
  /// Marlin's 95 bytes less `N999999999 ` and `*255`.
  static constexpr std::size_t kMaxText = 80;

  /// Fails (kInput) with the reason.
  [[nodiscard]] static Result<Line> make(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }

  friend bool operator==(const Line&, const Line&) = default;

 private:
  explicit Line(std::string_view text) : text_(text) {}

  std::string text_;
};

/// A line of a G-code file as a `Line`: comments (`;` to the end, `(…)`), line numbers and
/// checksums of the file are dropped, runs of blanks become one. Nothing when nothing is left.
/// Numbers stay as they are, unless the line is too long: then those of a G command get five
/// decimals, and a message loses its end. A message (M117, M118, M0, M1, M486) loses the bytes that
/// cannot be sent as well; so does the file its byte order mark, and words to other hosts ("@…")
/// are comments. Fails (kInput) when what is left is no `Line`, or has no place in a job
/// (job_rules.h).
[[nodiscard]] Result<std::optional<Line>> normalise(std::string_view raw);

/// Whether `text` is the command `code`, as "M105" or "G28", with or without parameters.
[[nodiscard]] bool is_command(std::string_view text, std::string_view code);

}  // namespace slipstick
