#include "sim/junction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipstick {

namespace {

/// mm/s: at a corner that turns right back.
constexpr double kSlowest = 0.05;
/// Moves shorter than this that turn by less than 45° are taken as pieces of an arc.
constexpr double kArcPieceMax = 1.0;
constexpr double kStraight = 0.999999;
/// What is left of a speed that is as good as none of the corner's own.
constexpr double kNoCoasting = 0.99;

/// The share of `speeds` at which none is over its limit.
double share_within(const std::array<double, Axes::kCount>& speeds, const Axes& limits) {
  const auto most = limits.all();
  double share = 1;
  for (std::size_t i = 0; i < Axes::kCount; ++i) {
    if (speeds[i] * share > most[i]) share = most[i] / speeds[i];
  }
  return share;
}

double change(double from, double to) {
  const bool turns = from * to < 0;
  return turns ? std::max(std::abs(from), std::abs(to)) : std::abs(from - to);
}

}  // namespace

double deviation_speed2(const Leg& before, const Leg& after, const MotionLimits& limits) {
  const double straightness = std::min(dot(before.corner, after.corner), kStraight);
  if (straightness < -kStraight) return kSlowest * kSlowest;
  const Axes turn = after.corner - before.corner;
  const double turn_length = length(turn);
  const double along = turn_length > 0 ? limited(after.acceleration, (1 / turn_length) * turn,
                                                 limits.acceleration_max)
                                       : after.acceleration;
  // Half angle identities, with θ the angle inside the corner: cos θ = -straightness.
  const double sine = std::sqrt((1 + straightness) / 2);
  double speed2 = along * limits.junction_deviation * sine / (1 - sine);
  if (after.length < kArcPieceMax && straightness > std::numbers::sqrt2 / 2) {
    speed2 = std::min(speed2, along * after.length / std::acos(straightness));
  }
  const double cruise = std::min(before.cruise, after.cruise);
  return std::min(speed2, cruise * cruise);
}

double safe_speed(const Leg& leg, const Axes& jerk) {
  std::array<double, Axes::kCount> speeds{};
  const auto motors = leg.motors.all();
  for (std::size_t i = 0; i < Axes::kCount; ++i) speeds[i] = std::abs(motors[i]) * leg.cruise;
  return leg.cruise * share_within(speeds, jerk);
}

double jerk_speed(const Leg& before, const Leg& after, const Axes& jerk) {
  const double cruise = std::min(before.cruise, after.cruise);
  std::array<double, Axes::kCount> changes{};
  const auto from = before.motors.all();
  const auto to = after.motors.all();
  for (std::size_t i = 0; i < Axes::kCount; ++i) {
    changes[i] = change(from[i] * cruise, to[i] * cruise);
  }
  const double speed = cruise * share_within(changes, jerk);
  const double safe = safe_speed(after, jerk);
  return std::min(safe, safe_speed(before, jerk)) > kNoCoasting * speed ? safe : speed;
}

}  // namespace slipstick
