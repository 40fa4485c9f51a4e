#pragma once

#include <vector>

#include "drivers/marlin/line.h"

namespace slipstick {

/// The lines of a print so far that set the board up (limits of speed and acceleration, flow,
/// pressure advance, …): what a board forgets when it is reset, and no other line tells.
class BoardSettings {
 public:
  /// More are more than a start needs; then the oldest are forgotten.
  static constexpr std::size_t kMax = 64;

  /// The print goes on with `line`.
  void follow(const Line& line);

  /// In the order in which they were last said, each once.
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

 private:
  std::vector<Line> lines_;
};

}  // namespace slipstick
