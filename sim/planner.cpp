#include "sim/planner.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace slipstick {

namespace {

double to_seconds(Moment m) {
  return std::chrono::duration<double>(m).count();
}
Moment rounded_up(double seconds) {
  return Moment(static_cast<Moment::rep>(std::ceil(seconds * 1e6)));
}

/// Ends are doubles, events whole microseconds: an end this close to now has come.
constexpr double kSlack = 1e-9;
bool is_too_short(const Axes& delta, const Axes& steps_per_mm) {
  const auto d = delta.all();
  const auto s = steps_per_mm.all();
  for (std::size_t i = 0; i < Axes::kCount; ++i) {
    if (std::abs(d[i]) * s[i] >= Planner::kStepsMin) return false;
  }
  return true;
}

double base_acceleration(const Axes& delta, const MotionLimits& limits) {
  if (delta.xyz() == Vec3{}) return limits.retract_acceleration;
  return delta.e != 0 ? limits.print_acceleration : limits.travel_acceleration;
}

}  // namespace

/// A move that follows on no other starts from rest: with classic jerk, at the speed that all axes
/// may start with.
void Planner::plan_entry(Block& b, const MotionLimits& limits) const {
  if (waiting() > 0) {
    const Leg& before = block(count_ - 1).leg;
    const double speed = limits.jerk ? jerk_speed(before, b.leg, *limits.jerk) : 0;
    b.entry2_max = limits.jerk ? speed * speed : deviation_speed2(before, b.leg, limits);
  } else if (limits.jerk) {
    const double speed = safe_speed(b.leg, *limits.jerk);
    b.entry2_max = speed * speed;
    b.entry2 = std::min(b.entry2_max, 2 * b.leg.acceleration * b.leg.length);
  }
}

Planner::Block Planner::planned(const Axes& target, double speed,
                                const MotionLimits& limits) const {
  const Axes delta = target - target_;
  const double path = slipstick::length(delta.xyz());
  Block b;
  Leg& leg = b.leg;
  leg.length = path > 0 ? path : std::abs(delta.e);
  b.direction = (1 / leg.length) * delta;
  leg.motors = (1 / leg.length) * (kinematics_.motors(target) - kinematics_.motors(target_));
  leg.corner = kinematics_.corner_direction(b.direction, leg.motors);
  leg.cruise = speed;

  // SLOWDOWN: the fewer moves are queued, the longer short ones take.
  const double seconds = leg.length / speed;
  if (waiting() >= 2 && waiting() < kBlocks / 2 && seconds < limits.segment_seconds_min) {
    leg.cruise = leg.length / (seconds + 2 * (limits.segment_seconds_min - seconds) / waiting());
  }
  leg.cruise = limited(leg.cruise, leg.motors, limits.speed_max);
  leg.acceleration =
      advance_limited(base_acceleration(delta, limits), path > 0 ? b.direction.e : 0, limits);
  leg.acceleration = limited(leg.acceleration, leg.motors, limits.acceleration_max);
  plan_entry(b, limits);
  b.move = {target_, target, leg.cruise, 0, 0};
  return b;
}

void Planner::add(const Axes& target, double speed, const MotionLimits& limits, Moment now) {
  SLIPSTICK_CHECK(!full() && speed > 0);
  if (is_too_short(kinematics_.motors(target) - kinematics_.motors(target_), limits.steps_per_mm)) {
    return;
  }

  block(count_) = planned(target, speed, limits);
  target_ = target;
  ++count_;
  if (count_ == 1) held_back_ = to_seconds(now);
  if (count_ == kCompany) company_at_ = to_seconds(now);
  look_ahead();
}

/// Backwards so that each move can slow down for the next, forwards so that each can speed up to
/// it. The move being made, and the speed at which it hands over, stay as they are.
void Planner::look_ahead() {
  const int fixed = moving_ ? 1 : 0;
  double next2 = 0;
  for (int i = count_ - 1; i > fixed; --i) {
    Block& b = block(i);
    b.entry2 = std::min(b.entry2_max, next2 + 2 * b.leg.acceleration * b.leg.length);
    next2 = b.entry2;
  }
  for (int i = fixed; i + 1 < count_; ++i) {
    const Block& b = block(i);
    Block& after = block(i + 1);
    after.entry2 = std::min(after.entry2, b.entry2 + 2 * b.leg.acceleration * b.leg.length);
  }
}

double Planner::start_seconds() const {
  const double patience = held_back_ + kFirstMoveDelay;
  return count_ >= kCompany ? std::min(patience, std::max(held_back_, company_at_)) : patience;
}

void Planner::start(double at) {
  Block& b = block(0);
  const double exit2 = count_ > 1 ? block(1).entry2 : 0;
  profile_ = Trapezoid(
      {b.leg.length, std::sqrt(b.entry2), b.leg.cruise, std::sqrt(exit2), b.leg.acceleration});
  b.move.start_seconds = at;
  b.move.end_seconds = at + profile_.seconds();
  moving_ = true;

  if (waiting_since_) {
    ++statistics_.starvations;
    statistics_.starved_seconds += at - *waiting_since_;
    waiting_since_.reset();
  }
  if (statistics_.first_extrusion_seconds <= 0 && b.move.filament() > 0) {
    statistics_.first_extrusion_seconds = at;
  }
}

void Planner::finish() {
  const ExecutedMove& move = block(0).move;
  ++statistics_.moves;
  statistics_.filament_mm += move.filament();
  statistics_.last_move_seconds = move.end_seconds;
  if (sink_) sink_(move);
  const double end = move.end_seconds;
  first_ = (first_ + 1) % kBlocks;
  --count_;
  moving_ = false;
  if (count_ > 0) {
    start(end);
  } else {
    waiting_since_ = end;
  }
}

Axes Planner::stop(Moment now) {
  target_ = position(now);
  if (moving_) {
    block(0).move.to = target_;
    block(0).move.end_seconds = to_seconds(now);
    count_ = 1;
    finish();
  }
  count_ = 0;
  rest();
  return target_;
}

void Planner::advance(Moment now) {
  const double t = to_seconds(now) + kSlack;
  if (count_ > 0 && !moving_ && start_seconds() <= t) start(start_seconds());
  while (moving_ && block(0).move.end_seconds <= t) finish();
}

std::optional<Moment> Planner::next_event() const {
  if (count_ == 0) return std::nullopt;
  return rounded_up(moving_ ? block(0).move.end_seconds : start_seconds());
}

Axes Planner::position(Moment now) const {
  if (count_ == 0) return target_;
  const Block& b = block(0);
  if (!moving_) return b.move.from;
  return b.move.from + profile_.distance_at(to_seconds(now) - b.move.start_seconds) * b.direction;
}

}  // namespace slipstick
