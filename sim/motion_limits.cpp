#include "sim/motion_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipstick {

double extruder_jerk(const MotionLimits& limits) {
  if (limits.jerk) return limits.jerk->e;
  // That of a right angle: s / (1 - s) with s the sine of half of it.
  constexpr double kSine = std::numbers::sqrt2 / 2;
  return std::sqrt(limits.junction_deviation * limits.acceleration_max.e * kSine / (1 - kSine));
}

double advance_limited(double wanted, double filament_per_mm, const MotionLimits& limits) {
  constexpr double kMostFilament = 3;
  if (limits.advance <= 0 || filament_per_mm <= 0 || filament_per_mm > kMostFilament) return wanted;
  return std::min(wanted, extruder_jerk(limits) / (limits.advance * filament_per_mm));
}

}  // namespace slipstick
