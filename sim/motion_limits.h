#pragma once

#include <optional>

#include "sim/axes.h"

namespace slipstick {

/// How fast the machine may move: what M201, M203, M204, M205 and M900 set. Marlin's default
/// configuration. Limits of axes are those of motors (kinematics.h).
struct MotionLimits {
  Axes steps_per_mm{80, 80, 400, 500};
  Axes speed_max{300, 300, 5, 25};                ///< mm/s.
  Axes acceleration_max{3000, 3000, 100, 10000};  ///< mm/s².
  double print_acceleration = 3000;
  double retract_acceleration = 3000;
  double travel_acceleration = 3000;
  double junction_deviation = 0.013;   ///< mm.
  double segment_seconds_min = 0.020;  ///< Shorter moves are stretched while few are queued.
  std::optional<Axes> jerk;            ///< mm/s: classic jerk, in place of junction deviation.
  double advance = 0;                  ///< K of linear advance, seconds.
};

/// Of a firmware that is built with classic jerk.
inline constexpr Axes kDefaultJerk{10, 10, 0.3, 5};

/// The most that E may change its speed by at once, mm/s.
[[nodiscard]] double extruder_jerk(const MotionLimits& limits);

/// The acceleration, no more than `wanted`, at which linear advance asks no more of the extruder
/// than that, for a move of `filament_per_mm` (Marlin 2.1.2: not for moves that retract, or push
/// more than 3 mm a mm).
[[nodiscard]] double advance_limited(double wanted, double filament_per_mm,
                                     const MotionLimits& limits);

}  // namespace slipstick
