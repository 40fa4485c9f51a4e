#include "sim/reports.h"

#include <fmt/format.h>

#include <cmath>

namespace slipstick {

namespace {

std::string axes_line(std::string_view code, const Axes& a) {
  return fmt::format("  {} X{:.2f} Y{:.2f} Z{:.2f} E{:.2f}\n", code, a.x, a.y, a.z, a.e);
}

long steps(double mm, double per_mm) {
  return std::lround(mm * per_mm);
}

}  // namespace

std::string steps_line(const MotionLimits& limits) {
  return axes_line("M92", limits.steps_per_mm);
}

std::string speed_line(const MotionLimits& limits) {
  return axes_line("M203", limits.speed_max);
}

std::string acceleration_max_line(const MotionLimits& limits) {
  return axes_line("M201", limits.acceleration_max);
}

std::string acceleration_line(const MotionLimits& limits) {
  return fmt::format("  M204 P{:.2f} R{:.2f} T{:.2f}\n", limits.print_acceleration,
                     limits.retract_acceleration, limits.travel_acceleration);
}

std::string advanced_line(const MotionLimits& limits) {
  const std::string corners = limits.jerk
                                  ? fmt::format("X{:.2f} Y{:.2f} Z{:.2f} E{:.2f}", limits.jerk->x,
                                                limits.jerk->y, limits.jerk->z, limits.jerk->e)
                                  : fmt::format("J{:.2f}", limits.junction_deviation);
  return fmt::format("  M205 B{:.2f} S0.00 T0.00 {}\n", limits.segment_seconds_min * 1e6, corners);
}

std::string settings_report(const Machine& machine) {
  const MotionLimits& limits = machine.limits;
  return "echo:; Linear Units:\n"
         "echo:  G21 ; (mm)\n"
         "echo:; Temperature Units:\n"
         "echo:  M149 C ; Units in Celsius\n"
         "echo:; Filament settings (Disabled):\n"
         "echo:  M200 S0 D1.75\n"
         "echo:; Steps per unit:\n"
         "echo:" +
         steps_line(limits) +
         "echo:; Max feedrates (units/s):\n"
         "echo:" +
         speed_line(limits) +
         "echo:; Max Acceleration (units/s2):\n"
         "echo:" +
         acceleration_max_line(limits) +
         "echo:; Acceleration (units/s2) (P<print-accel> R<retract-accel> T<travel-accel>):\n"
         "echo:" +
         acceleration_line(limits) +
         "echo:; Advanced (B<min_segment_time_us> S<min_feedrate> T<min_travel_feedrate> " +
         (limits.jerk ? "X<max_jerk> Y<max_jerk> Z<max_jerk> E<max_jerk>" : "J<junc_dev>") +
         "):\n"
         "echo:" +
         advanced_line(limits) +
         "echo:; Home offset:\n"
         "echo:  M206 X0.00 Y0.00 Z0.00\n"
         "echo:; Hotend PID:\n"
         "echo:  M301 P22.20 I1.08 D114.00\n" +
         (machine.options.features.has(Feature::kLinearAdvance)
              ? fmt::format("echo:; Linear Advance:\necho:  M900 K{:.2f}\n", limits.advance)
              : "");
}

std::string position_report(const Machine& machine, Moment now) {
  const Axes& p = machine.position;
  const Kinematics& kinematics = machine.options.kinematics;
  const Axes at = kinematics.motors(machine.planner.position(now));
  const Axes& per_mm = machine.limits.steps_per_mm;
  const std::string_view names = kinematics.motor_names();
  return fmt::format("X:{:.2f} Y:{:.2f} Z:{:.2f} E:{:.2f} Count {}:{} {}:{} {}:{}\n", p.x, p.y, p.z,
                     p.e, names[0], steps(at.x, per_mm.x), names[1], steps(at.y, per_mm.y),
                     names[2], steps(at.z, per_mm.z));
}

std::string temperature_text(const Machine& machine) {
  const Heater& nozzle = machine.nozzle;
  const Heater& bed = machine.bed;
  return fmt::format(" T:{:.2f} /{:.2f} B:{:.2f} /{:.2f} @:{} B@:{}", nozzle.celsius(),
                     nozzle.target(), bed.celsius(), bed.target(), nozzle.power(), bed.power());
}

}  // namespace slipstick
