#include "host/status_pace.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/gcode/parse.h"
#include "drivers/marlin/patience.h"

namespace slipstick {
namespace {

constexpr std::array<int, 2> kCodes{73, 117};
constexpr std::size_t kNoKind = kCodes.size();
constexpr double kForever = std::numeric_limits<double>::infinity();

std::size_t kind_of(const std::optional<GcodeCommand>& command) {
  std::size_t kind = 0;
  while (kind < kNoKind && !(command && command->is('M', kCodes[kind]))) ++kind;
  return kind;
}

bool is_move(const std::optional<GcodeCommand>& command) {
  return command && command->letter() == 'G' && command->code() <= 3;
}

/// Of a move between two places, at least: acceleration is not looked at, and of an arc only its
/// chord. For ever where that is not known, so that nothing is held back.
double seconds(const Position& from, const PrintState& to) {
  double squares = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!from[axis] || !to.position[axis]) return kForever;
    squares += std::pow(*to.position[axis] - *from[axis], 2);
  }
  return to.feed && *to.feed > 0 ? std::sqrt(squares) / (*to.feed / 60) : kForever;
}

}  // namespace

void StatusPace::push(Line line) {
  const auto command = parse_gcode(line.text());
  if (const std::size_t kind = kind_of(command); kind != kNoKind) {
    kinds_[kind].latest = std::move(line);
    if (kinds_[kind].quiet >= kSeconds) send(kinds_[kind]);
    return;
  }
  const bool waits = is_blocking(line.text());
  for (Kind& kind : kinds_) {
    if (waits || kind.quiet >= kSeconds) send(kind);
  }
  const Position from = state_.state().position;
  state_.follow(line.text());
  const double lasts = is_move(command) ? seconds(from, state_.state()) : waits ? kForever : 0;
  for (Kind& kind : kinds_) kind.quiet += lasts;
  ready_.push_back(std::move(line));
}

void StatusPace::end() {
  for (Kind& kind : kinds_) send(kind);
}

std::optional<Line> StatusPace::pop() {
  if (ready_.empty()) return std::nullopt;
  std::optional<Line> line = std::move(ready_.front());
  ready_.pop_front();
  return line;
}

void StatusPace::send(Kind& kind) {
  if (!kind.latest) return;
  ready_.push_back(*std::exchange(kind.latest, std::nullopt));
  kind.quiet = 0;
}

}  // namespace slipstick
