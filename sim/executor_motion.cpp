// Where commands take the machine: moves, arcs, homing, names of places.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/cut_move.h"
#include "sim/executor.h"
#include "sim/reports.h"

namespace slipstick {

Axes Executor::destination(const GcodeCommand& command) const {
  const Axes& from = machine_.position;
  const auto coordinate = [&](char name, double was, bool relative) {
    const double value = command.value(name).value_or(relative ? 0 : was);
    return std::clamp(relative ? was + value : value, -kFarthest, kFarthest);
  };
  return {coordinate('X', from.x, machine_.relative), coordinate('Y', from.y, machine_.relative),
          coordinate('Z', from.z, machine_.relative), coordinate('E', from.e, machine_.relative_e)};
}

Axes Executor::within_endstops(Axes to) const {
  if (!machine_.homed || !machine_.soft_endstops) return to;
  const Axes& shift = machine_.shift;
  const MachineOptions& built = machine_.options;
  to = built.kinematics.within({to.x + shift.x, to.y + shift.y, to.z + shift.z, to.e},
                               built.build_volume);
  return {to.x - shift.x, to.y - shift.y, to.z - shift.z, to.e};
}

double Executor::allowed_extrusion(double e) {
  if (e == 0) return 0;
  if (machine_.nozzle.celsius() < machine_.extrude_celsius_min) {
    text_ += kColdExtrusion;
    return 0;
  }
  if (std::abs(e) > kExtrusionMax) {
    text_ += kLongExtrusion;
    return 0;
  }
  return e;
}

void Executor::take_feedrate(const GcodeCommand& command) {
  if (const double f = command.value('F').value_or(0); f > 0) machine_.feedrate = f / 60;
}

void Executor::move(const GcodeCommand& command) {
  take_feedrate(command);
  const Axes to = within_endstops(destination(command));
  const int pieces = machine_.options.kinematics.pieces(machine_.position, to, speed());
  if (pieces == 1) return head_for(to);
  // What is not to be pushed is refused once, not with every piece.
  if (allowed_extrusion(to.e - machine_.position.e) == 0) machine_.position.e = to.e;
  way_ =
      Way{[cut = CutMove(machine_.position, to, pieces)](int i) { return cut.end_of(i); }, pieces};
  static_cast<void>(head_for_next_piece());
}

double Executor::speed() const {
  return std::max(Planner::kSlowest, machine_.feedrate * machine_.feedrate_percent / 100);
}

void Executor::arc(const GcodeCommand& command) {
  take_feedrate(command);
  if (const auto arc = Arc::of(command, machine_.position, destination(command))) {
    way_ = Way{[arc = *arc](int i) { return arc.end_of(i); }, arc->pieces()};
  }
  if (!head_for_next_piece()) text_ += kBadArc;
}

bool Executor::head_for_next_piece() {
  if (!way_) return false;
  head_for(within_endstops(way_->end_of(way_->next)));
  if (way_->next++ == way_->pieces) way_.reset();
  return true;
}

void Executor::head_for(const Axes& to) {
  const double e = allowed_extrusion(to.e - machine_.position.e);
  machine_.filament += e * machine_.flow_percent / 100;
  machine_.position = to;
  const Axes& shift = machine_.shift;
  target_ = {to.x + shift.x, to.y + shift.y, to.z + shift.z, machine_.filament};
  speed_ = speed();
  stage_ = Stage::kRoom;
}

void Executor::plan_to(const Axes& to, double speed) {
  machine_.filament = to.e;
  target_ = to;
  speed_ = speed;
  stage_ = Stage::kRoom;
}

void Executor::quick_stop(Moment now) {
  const Axes at = machine_.planner.stop(now);
  const Axes& shift = machine_.shift;
  machine_.filament = at.e;
  machine_.position = {at.x - shift.x, at.y - shift.y, at.z - shift.z, machine_.position.e};
  way_.reset();
  target_ = at;
}

void Executor::home(const GcodeCommand& command) {
  const MachineOptions& built = machine_.options;
  const Vec3 home = built.kinematics.home(built.build_volume);
  const bool all =
      built.kinematics.homes_all() || (!command.has('X') && !command.has('Y') && !command.has('Z'));
  homed_to_ = machine_.planner.target();
  homed_to_.e = machine_.filament;
  homed_shift_ = machine_.shift;
  const auto name = [](double& to, double& shift, double place) {
    to = place;
    shift = 0;
  };
  if (all || command.has('X')) name(homed_to_.x, homed_shift_.x, home.x);
  if (all || command.has('Y')) name(homed_to_.y, homed_shift_.y, home.y);
  if (all || command.has('Z')) name(homed_to_.z, homed_shift_.z, home.z);
  wait_ = kHomingTime;
  become_still(Stage::kHome);
}

void Executor::probe_bed() {
  if (!machine_.homed) {
    text_ += "echo:Home XYZ First\n";
    return;
  }
  wait_ = kProbingTime;
  become_still(Stage::kDwell);
  then([this](Moment) {
    machine_.leveling.probe();
    text_ += machine_.leveling.grid_text();
  });
}

void Executor::set_advance(const GcodeCommand& command) {
  constexpr double kMost = 10;
  const auto k = command.value('K');
  if (!k) {
    text_ += fmt::format("echo:Advance K={:.2f}\n", machine_.limits.advance);
  } else if (*k < 0 || *k > kMost) {
    text_ += "?K value out of range (0-10).\n";
  } else if (*k != machine_.limits.advance) {
    machine_.limits.advance = *k;
    become_still(Stage::kDone);
  }
}

void Executor::finish_homing(Moment now) {
  machine_.planner.set_position(homed_to_);
  machine_.position = {homed_to_.x - homed_shift_.x, homed_to_.y - homed_shift_.y,
                       homed_to_.z - homed_shift_.z, machine_.position.e};
  machine_.shift = homed_shift_;
  machine_.homed = true;
  text_ += position_report(machine_, now);
}

void Executor::rename_position(const GcodeCommand& command, Moment now) {
  const Axes was = machine_.position;
  Axes& p = machine_.position;
  const auto named = [&](char name, double old) {
    return std::clamp(command.value(name).value_or(old), -kFarthest, kFarthest);
  };
  p = {named('X', was.x), named('Y', was.y), named('Z', was.z), named('E', was.e)};
  machine_.shift = machine_.shift + (was - p);
  text_ += position_report(machine_, now);
}

}  // namespace slipstick
