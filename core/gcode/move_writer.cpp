#include "core/gcode/move_writer.h"

#include <cmath>

#include "core/base/number_text.h"

namespace slipstick {
namespace {

constexpr double kMicrometre = 1e-3;
constexpr double kFilamentStep = 1e-5;  // mm
constexpr double kSecondsPerMinute = 60;

// Seconds for a move that starts and stops within the limits of speed and acceleration.
double duration(double length, double speed, double acceleration) {
  const double ramp = speed * speed / acceleration;  // length of both ramps together
  if (length < ramp) return 2 * std::sqrt(length / acceleration);
  return length / speed + speed / acceleration;
}

}  // namespace

void MoveWriter::line(std::string_view text) {
  text_ += text;
  text_ += '\n';
}

void MoveWriter::retracted_by(double mm) {
  const MaterialSettings& m = settings_.material;
  if (mm == m.retraction) return;
  text_ += "G1 E";
  append_rounded(text_, mm - m.retraction, 5);
  append_feed(m.retraction_speed);
  text_ += '\n';
}

void MoveWriter::height(double z) {
  if (z == z_) return;
  if (!retracted_) retract();
  z_ = z;
  text_ += "G0 Z";
  append_rounded(text_, z, 3);
  append_feed(settings_.printer.z_speed_max);
  text_ += '\n';
}

void MoveWriter::travel(Vec2 to) {
  const Micrometres target = rounded(to);
  if (has_position_ && target == at_) return unretract();
  const double length = has_position_ ? way(target) : 0;
  if (!has_position_ || length > settings_.toolpath.retract_travel_min) retract();
  move("G0", target, settings_.toolpath.travel_speed);
  text_ += '\n';
  seconds_ +=
      duration(length, settings_.toolpath.travel_speed, settings_.printer.travel_acceleration);
  unretract();
}

void MoveWriter::extrude(Vec2 to, double filament, double speed) {
  owed_filament_ += filament;
  const Micrometres target = rounded(to);
  if (target == at_) return;
  const double length = way(target);
  text_ += "G1";
  append_xy(target);
  append_e(owed_filament_);
  append_feed(speed);
  text_ += '\n';
  at_ = target;
  seconds_ += duration(length, speed, settings_.printer.acceleration);
}

void MoveWriter::retract() {
  if (retracted_) return;
  retracted_ = true;
  const MaterialSettings& m = settings_.material;
  if (m.retraction <= 0) return;
  text_ += "G1 E-";
  append_rounded(text_, m.retraction, 5);
  append_feed(m.retraction_speed);
  text_ += '\n';
  seconds_ += m.retraction / m.retraction_speed;
}

void MoveWriter::unretract() {
  if (!retracted_) return;
  retracted_ = false;
  const MaterialSettings& m = settings_.material;
  if (m.retraction <= 0) return;
  text_ += "G1 E";
  append_rounded(text_, m.retraction, 5);
  append_feed(m.retraction_speed);
  text_ += '\n';
  seconds_ += m.retraction / m.retraction_speed;
}

void MoveWriter::move(std::string_view command, Micrometres to, double speed) {
  text_ += command;
  append_xy(to);
  append_feed(speed);
  at_ = to;
  has_position_ = true;
}

void MoveWriter::append_xy(Micrometres to) {
  if (!has_position_ || to.x != at_.x) {
    text_ += " X";
    append_rounded(text_, static_cast<double>(to.x) * kMicrometre, 3);
  }
  if (!has_position_ || to.y != at_.y) {
    text_ += " Y";
    append_rounded(text_, static_cast<double>(to.y) * kMicrometre, 3);
  }
}

// Writes what can be said of the filament owed and carries the rest on.
void MoveWriter::append_e(double filament) {
  const double written = std::round(filament / kFilamentStep) * kFilamentStep;
  owed_filament_ = filament - written;
  filament_ += written;
  text_ += " E";
  append_rounded(text_, written, 5);
}

void MoveWriter::append_feed(double speed) {
  const long feed = std::lround(speed * kSecondsPerMinute);
  if (feed == feed_) return;
  feed_ = feed;
  text_ += " F";
  text_ += std::to_string(feed);
}

MoveWriter::Micrometres MoveWriter::rounded(Vec2 p) {
  return {std::llround(p.x / kMicrometre), std::llround(p.y / kMicrometre)};
}

double MoveWriter::way(Micrometres to) const {
  const Vec2 along{static_cast<double>(to.x - at_.x), static_cast<double>(to.y - at_.y)};
  return length(along) * kMicrometre;
}

}  // namespace slipstick
