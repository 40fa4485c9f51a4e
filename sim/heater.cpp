#include "sim/heater.h"

#include <algorithm>
#include <cmath>

namespace slipstick {

namespace {

// Marlin's default configuration: M301 P22.20 I1.08 D114.00, of 255 steps of power.
constexpr double kP = 22.20;
constexpr double kI = 1.08;
constexpr double kD = 114.0;
constexpr double kSteps = 255;
constexpr double kDerivativeMemory = 0.95;  ///< PID_K1.

double seconds(Moment m) {
  return std::chrono::duration<double>(m).count();
}

}  // namespace

HeaterOptions nozzle_options() {
  return {.fan_loss = 0.1};
}

HeaterOptions bed_options() {
  return {.rise_max = 133,
          .time_constant = 90,
          .target_max = 140,
          .control = HeaterOptions::Control::kBangBang};
}

void Heater::set_target(double celsius) {
  target_ = std::clamp(celsius, 0.0, options_.target_max);
}

int Heater::power() const {
  return static_cast<int>(share_ * kPowerMax);
}

void Heater::shut_off() {
  target_ = 0;
  share_ = 0;
}

double Heater::celsius() const {
  if (defect_ == HeaterDefect::kSensorOpen) return kOpenCelsius;
  if (defect_ == HeaterDefect::kSensorShorted) return kShortCelsius;
  return celsius_ + off_by_;
}

void Heater::read_sensor() {
  if (options_.noise > 0) off_by_ = options_.noise * (2 * rng_.unit() - 1);
}

double Heater::true_share() const {
  if (defect_ == HeaterDefect::kCold) return 0;
  return defect_ == HeaterDefect::kStuck ? 1 : share_;
}

double Heater::pid() {
  const double dt = seconds(kControlPeriod);
  const double error = target_ - celsius();
  derivative_ = kDerivativeMemory * derivative_ +
                (1 - kDerivativeMemory) * (kD / dt) * (last_celsius_ - celsius());
  last_celsius_ = celsius();
  if (target_ <= 0 || error < -kPidRange) return 0;
  if (error > kPidRange) {
    integral_ = 0;
    return kSteps;
  }
  integral_ = std::clamp(integral_ + kI * dt * error, 0.0, kSteps);
  return std::clamp(kP * error + integral_ + derivative_, 0.0, kSteps);
}

void Heater::control() {
  read_sensor();
  if (options_.control == HeaterOptions::Control::kPid) {
    share_ = pid() / kSteps;
    next_control_ += kControlPeriod;
  } else {
    share_ = celsius() < target_ ? 1 : 0;
    next_control_ += kBedCheckPeriod;
  }
}

void Heater::warm(Moment to) {
  const double loss = 1 + options_.fan_loss * draught_;
  const double settles_at = kRoomCelsius + true_share() * options_.rise_max / loss;
  celsius_ = settles_at + (celsius_ - settles_at) *
                              std::exp(-seconds(to - now_) * loss / options_.time_constant);
  now_ = to;
}

void Heater::advance(Moment to) {
  while (now_ < to) {
    if (next_control_ <= now_) control();
    warm(std::min(to, next_control_));
  }
}

void Heater::coast(Moment to) {
  if (now_ < to) warm(to);
  next_control_ = std::max(next_control_, now_);
}

void Residency::see(double celsius, double target, Moment now) {
  const double off = std::abs(celsius - target);
  if (!since_ ? off < kWindow : off > kHysteresis) since_ = now;
}

std::optional<std::int64_t> Residency::seconds_left(Moment now) const {
  if (!since_) return std::nullopt;
  return std::max<Moment>(Moment(0), *since_ + kDuration - now).count() / Moment::period::den;
}

}  // namespace slipstick
