#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "host/line_source.h"
#include "sim/planner.h"

namespace slipstick::test {

/// A small print, and what a machine lays of it.

/// A start and forty beads, which end at no place twice and are too long for the planner to
/// stretch. \param extrusion "M82" or "M83".
inline std::vector<std::string> spiral(const std::string& extrusion) {
  std::vector<std::string> lines{"M104 S200", "M109 S200", "G28",
                                 extrusion,   "G92 E0",    "G1 X100 Y100 Z0.3 F6000"};
  for (int i = 1; i <= 40; ++i) {
    const int reach = i % 2 == 0 ? 10 + i : -10 - i;
    const double e = extrusion == "M83" ? 0.1 : 0.1 * i;
    lines.push_back("G1 X" + std::to_string(100 + reach) + " Y" + std::to_string(100 + i) + " E" +
                    std::to_string(e) + (i % 7 == 0 ? " F3000" : ""));
  }
  return lines;
}

class ProgramLines final : public LineSource {
 public:
  explicit ProgramLines(std::vector<std::string> lines) : lines_(std::move(lines)) {}
  Result<std::optional<Line>> next() override {
    if (given_ == lines_.size()) return std::optional<Line>();
    return normalise(lines_[given_++]);
  }
  bool ready() const override { return true; }

 private:
  std::vector<std::string> lines_;
  std::size_t given_ = 0;
};

/// From where to where, how much and how fast, in thousandths: units that rounding does not reach.
using Bead = std::array<long, 7>;

/// Collects the beads that a simulated machine lays.
inline Planner::Sink into(std::vector<Bead>& beads) {
  return [&beads](const ExecutedMove& move) {
    const auto micro = [](double mm) { return std::lround(mm * 1000); };
    if (move.filament() <= 0 || (move.from.x == move.to.x && move.from.y == move.to.y)) return;
    beads.push_back({micro(move.from.x), micro(move.from.y), micro(move.to.x), micro(move.to.y),
                     micro(move.to.z), micro(move.filament()), micro(move.speed)});
  };
}

}  // namespace slipstick::test
