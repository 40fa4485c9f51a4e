#include "drivers/marlin/sensor_watch.h"

#include <fmt/format.h>

#include <cmath>

namespace slipstick {
namespace {

/// Counts on from `before`; nothing is said of a heater that is not reported, or not to be hot.
int count(const std::optional<HeaterReading>& heater, double most, int before) {
  if (!heater) return before;
  if (!heater->target || !(*heater->target > 0)) return 0;
  const bool possible = heater->celsius >= SensorWatch::kColdest && heater->celsius <= most;
  return possible ? 0 : before + 1;
}

std::string fault(const char* heater, double celsius) {
  const std::string said = std::isfinite(celsius) ? fmt::format("{:g} °C", celsius) : "no number";
  return fmt::format("the sensor of the {} cannot be right: it says {}", heater, said);
}

}  // namespace

std::optional<std::string> SensorWatch::follow(const Temperatures& report) {
  nozzle_ = count(report.hotend, kNozzleMost, nozzle_);
  bed_ = count(report.bed, kBedMost, bed_);
  if (nozzle_ >= kReadings) return fault("nozzle", report.hotend ? report.hotend->celsius : NAN);
  if (bed_ >= kReadings) return fault("bed", report.bed ? report.bed->celsius : NAN);
  return {};
}

}  // namespace slipstick
