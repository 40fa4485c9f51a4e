#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace slipstick {

/// \file
/// One line of G-code -> its command and words, read as Marlin 2 reads it.

/// G1 X10 E0.5: a letter, a number and the words behind it. Views the line it was parsed from.
class GcodeCommand {
 public:
  GcodeCommand(char letter, int code, std::string_view text);

  /// 'G', 'M' or 'T'.
  [[nodiscard]] char letter() const { return letter_; }
  /// 1 for G1. A fraction (G29.1) is dropped.
  [[nodiscard]] int code() const { return code_; }
  [[nodiscard]] bool is(char letter, int code) const { return letter == letter_ && code == code_; }
  /// All that stands behind the command, as it was written: the message of M117.
  [[nodiscard]] std::string_view text() const { return text_; }

  /// Whether word `name` ('A' to 'Z') is there, with or without a number. The last one of a name
  /// counts.
  [[nodiscard]] bool has(char name) const { return (seen_ & bit(name)) != 0; }
  /// The number of word `name`, or nothing.
  [[nodiscard]] std::optional<double> value(char name) const {
    if ((valued_ & bit(name)) == 0) return std::nullopt;
    return values_[static_cast<std::size_t>(name - 'A')];
  }

 private:
  static constexpr std::uint32_t bit(char name) { return std::uint32_t{1} << (name - 'A'); }
  void read_words(std::string_view words);

  char letter_;
  int code_;
  std::string_view text_;
  std::uint32_t seen_ = 0;
  std::uint32_t valued_ = 0;
  std::array<double, 26> values_;  ///< Where `valued_` has a bit.
};

/// `line` without its comment, leading blanks, line number and checksum: "N5 G1 X1*33 ; a" -> "G1
/// X1".
[[nodiscard]] std::string_view bare_command(std::string_view line);

/// The command of `line`; nothing for a blank line, a comment or what is not G, M or T with a
/// number.
///
/// Upper-case letters only, words may touch each other (G1X2Y3), an E never begins an exponent.
/// \pre `line` holds no line end.
[[nodiscard]] std::optional<GcodeCommand> parse_gcode(std::string_view line);

}  // namespace slipstick
