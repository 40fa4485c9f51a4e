#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slipstick {

/// Bytes -> lines as Marlin's command reader cuts them.
///
/// A comment and all beyond the longest line are thrown away, a backslash too, a backspace takes a
/// byte back, and either line end closes a line unless nothing is in it.
class LineReader {
 public:
  /// MAX_CMD_SIZE is 96 with the NUL.
  static constexpr std::size_t kLengthMax = 95;

  explicit LineReader(std::size_t length_max = kLengthMax) : length_max_(length_max) {}

  /// The line that `byte` ends, valid until the next call.
  std::optional<std::string_view> feed(char byte);

 private:
  enum class State { kNormal, kEscaped, kSkipping };

  void add(char byte);
  void reset();

  State state_ = State::kNormal;
  std::size_t length_max_;
  bool done_ = false;
  std::string line_;
};

}  // namespace slipstick
