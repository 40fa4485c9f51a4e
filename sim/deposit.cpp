#include "sim/deposit.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/check.h"
#include "core/toolpath/flow.h"

namespace slipstick {

Deposit::Deposit(double filament_diameter, Sink sink)
    : filament_area_(std::numbers::pi * filament_diameter * filament_diameter / 4),
      sink_(std::move(sink)) {
  SLIPSTICK_CHECK(filament_diameter > 0);
}

void Deposit::enter_layer(double z) {
  if (!tops_.empty() && std::abs(z - tops_.back()) <= kSameZ) return;
  while (!tops_.empty() && tops_.back() >= z - kSameZ) tops_.pop_back();
  height_ = tops_.empty() ? z : z - tops_.back();
  tops_.push_back(z);
}

void Deposit::add(const ExecutedMove& move) {
  const Vec2 a{move.from.x, move.from.y};
  const Vec2 b{move.to.x, move.to.y};
  const double path = length(b - a);
  if (move.filament() <= 0 || path <= 0 || move.to.z <= kSameZ) return;
  enter_layer(move.to.z);
  const double area = move.filament() * filament_area_ / path;
  sink_({a, b, bead_width(area, height_), height_, move.to.z});
}

}  // namespace slipstick
