#include "sim/limit_commands.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/reports.h"

namespace slipstick {

namespace {

/// What a machine can have at least and at most, whatever a damaged line asks for.
constexpr double kLeast = 1e-3;
constexpr double kMost = 1e6;

/// Sets `value` to word `name` if it is there. \return Whether it is.
bool take(const GcodeCommand& command, char name, double& value) {
  const auto given = command.value(name);
  if (given && *given > 0) value = std::clamp(*given, kLeast, kMost);
  return given.has_value();
}

using Line = std::string (*)(const MotionLimits&);

std::string set_axes(const GcodeCommand& command, Machine& machine, Axes MotionLimits::*axes,
                     Line line) {
  Axes& a = machine.limits.*axes;
  bool any = take(command, 'X', a.x);
  any |= take(command, 'Y', a.y);
  any |= take(command, 'Z', a.z);
  any |= take(command, 'E', a.e);
  return any ? std::string() : line(machine.limits);
}

std::string set_accelerations(const GcodeCommand& command, MotionLimits& limits) {
  bool any = take(command, 'S', limits.print_acceleration);
  any |= take(command, 'S', limits.travel_acceleration);
  any |= take(command, 'P', limits.print_acceleration);
  any |= take(command, 'R', limits.retract_acceleration);
  any |= take(command, 'T', limits.travel_acceleration);
  return any ? std::string() : acceleration_line(limits);
}

std::string set_jerk(const GcodeCommand& command, MotionLimits& limits) {
  Axes& jerk = *limits.jerk;
  bool any = take(command, 'X', jerk.x);
  any |= take(command, 'Y', jerk.y);
  any |= take(command, 'Z', jerk.z);
  any |= take(command, 'E', jerk.e);
  if (const auto b = command.value('B')) {
    limits.segment_seconds_min = std::clamp(*b / 1e6, 0.0, 1.0);
    any = true;
  }
  return any ? std::string() : advanced_line(limits);
}

std::string set_advanced(const GcodeCommand& command, MotionLimits& limits) {
  if (limits.jerk) return set_jerk(command, limits);
  constexpr double kDeviationMin = 0.01;
  constexpr double kDeviationMax = 0.3;
  const auto b = command.value('B');
  const auto j = command.value('J');
  if (!b && !j) return advanced_line(limits);
  if (b) limits.segment_seconds_min = std::clamp(*b / 1e6, 0.0, 1.0);
  if (!j) return {};
  if (*j < kDeviationMin || *j > kDeviationMax) return "Error:?J out of range (0.01 to 0.3)\n";
  limits.junction_deviation = *j;
  return {};
}

std::string set_feedrate_percent(const GcodeCommand& command, double& percent) {
  const auto s = command.value('S');
  if (!s) return fmt::format("FR:{:.0f}%\n", percent);
  percent = std::clamp(*s, 10.0, 999.0);
  return {};
}

std::string set_flow_percent(const GcodeCommand& command, double& percent) {
  const auto s = command.value('S');
  if (!s) return fmt::format("echo:E0 Flow: {:.0f}%\n", percent);
  percent = std::clamp(*s, 0.0, 999.0);
  return {};
}

std::string set_cold_extrusion(const GcodeCommand& command, double& celsius_min) {
  if (const auto s = command.value('S')) {
    celsius_min = *s;
    return {};
  }
  return fmt::format("echo:Cold extrudes are {}abled (min temp {:.0f}C)\n",
                     celsius_min > 0 ? "dis" : "en", celsius_min);
}

}  // namespace

std::optional<std::string> run_limit_command(const GcodeCommand& command, Machine& machine) {
  if (command.letter() != 'M') return std::nullopt;
  switch (command.code()) {
    case 92:
      return set_axes(command, machine, &MotionLimits::steps_per_mm, steps_line);
    case 201:
      return set_axes(command, machine, &MotionLimits::acceleration_max, acceleration_max_line);
    case 203:
      return set_axes(command, machine, &MotionLimits::speed_max, speed_line);
    case 204:
      return set_accelerations(command, machine.limits);
    case 205:
      return set_advanced(command, machine.limits);
    case 220:
      return set_feedrate_percent(command, machine.feedrate_percent);
    case 221:
      return set_flow_percent(command, machine.flow_percent);
    case 302:
      return set_cold_extrusion(command, machine.extrude_celsius_min);
    default:
      return std::nullopt;
  }
}

}  // namespace slipstick
