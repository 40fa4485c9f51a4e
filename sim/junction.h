#pragma once

#include "sim/axes.h"
#include "sim/motion_limits.h"

namespace slipstick {

/// \file
/// How fast the machine may go around a corner: the two rules of Marlin's planner. Speeds in mm/s
/// along the path.

/// A move, as a corner sees it.
struct Leg {
  Axes corner;  ///< Unit vector that corners are measured by (kinematics.h).
  Axes motors;  ///< mm of each motor, and of E, per mm of path.
  double length = 0;
  double cruise = 0;
  double acceleration = 0;
};

/// The square of the speed from `before` into `after` by junction deviation, with Marlin's limit
/// for the pieces of an arc.
[[nodiscard]] double deviation_speed2(const Leg& before, const Leg& after,
                                      const MotionLimits& limits);

/// Classic jerk: the speed that no axis minds to start from, or stop at, at once.
[[nodiscard]] double safe_speed(const Leg& leg, const Axes& jerk);

/// The speed from `before` into `after` at which no axis changes its own by more than `jerk`; an
/// axis that turns round counts as much as the faster of its two speeds. Where that is no more than
/// both may stop at, `after` starts as from rest.
[[nodiscard]] double jerk_speed(const Leg& before, const Leg& after, const Axes& jerk);

}  // namespace slipstick
