#include "sim/thermal_guard.h"

#include <fmt/format.h>

namespace slipstick {

namespace {

/// This close to the target no rise is watched any more: TEMP_HYSTERESIS and one more.
constexpr double kClose = 4;
constexpr std::string_view kBed = "bed";

struct Words {
  std::string_view error;
  std::string_view screen;
};

Words words_of(ThermalAlarm alarm) {
  switch (alarm) {
    case ThermalAlarm::kMinTemp:
      return {"MINTEMP triggered", "Err: MINTEMP"};
    case ThermalAlarm::kMaxTemp:
      return {"MAXTEMP triggered", "Err: MAXTEMP"};
    case ThermalAlarm::kHeatingFailed:
      return {"Heating failed", "Heating Failed"};
    case ThermalAlarm::kRunaway:
      break;
  }
  return {"Thermal Runaway", "THERMAL RUNAWAY"};
}

}  // namespace

ThermalLimits nozzle_limits() {
  return {.name = "E0"};
}

ThermalLimits bed_limits() {
  return {.name = kBed,
          .celsius_max = 150,
          .watch = Moment(60'000'000),
          .runaway = Moment(20'000'000),
          .runaway_hysteresis = 2};
}

void ThermalGuard::watch_from(double celsius, Moment now) {
  rise_by_.reset();
  if (celsius + limits_.watch_rise >= target_ - kClose) return;
  rise_by_ = now + limits_.watch;
  rise_to_ = celsius + limits_.watch_rise;
}

void ThermalGuard::begin(const Heater& heater, Moment now) {
  target_ = heater.target();
  reached_ = false;
  watch_from(heater.celsius(), now);
}

bool ThermalGuard::failed_to_rise(double celsius, Moment now) {
  if (!rise_by_ || now < *rise_by_) return false;
  if (celsius < rise_to_) return true;
  watch_from(celsius, now);
  return false;
}

bool ThermalGuard::has_run_away(double celsius, Moment now) {
  if (celsius >= target_) reached_ = true;
  if (!reached_ || celsius >= target_ - limits_.runaway_hysteresis) below_since_ = now;
  return now - below_since_ > limits_.runaway;
}

std::optional<ThermalAlarm> ThermalGuard::check(const Heater& heater, Moment now) {
  const double celsius = heater.celsius();
  if (celsius > limits_.celsius_max) return ThermalAlarm::kMaxTemp;
  if (heater.target() != target_) begin(heater, now);
  if (target_ <= 0) return std::nullopt;
  if (celsius < limits_.celsius_min) return ThermalAlarm::kMinTemp;
  if (failed_to_rise(celsius, now)) return ThermalAlarm::kHeatingFailed;
  if (has_run_away(celsius, now)) return ThermalAlarm::kRunaway;
  return std::nullopt;
}

std::string alarm_text(ThermalAlarm alarm, std::string_view heater) {
  const Words words = words_of(alarm);
  return fmt::format("Error:{}, system stopped! Heater_ID: {}\n{}echo:{}\n", words.error, heater,
                     heater == kBed ? "" : "\n", words.screen);
}

}  // namespace slipstick
