#pragma once

#include <optional>
#include <string>

#include "drivers/marlin/temperatures.h"

namespace slipstick {

/// Watches the sensors of the heaters that are to be hot, for boards that do not do it themselves.
///
/// One reading may be noise; two in a row that no working sensor gives are a fault: no number, the
/// -15 °C of an open thermistor, or more than any heater of its kind reaches.
class SensorWatch {
 public:
  static constexpr double kColdest = -10;     ///< °C, of a working sensor in a cold room.
  static constexpr double kNozzleMost = 500;  ///< °C.
  static constexpr double kBedMost = 250;     ///< °C.
  static constexpr int kReadings = 2;         ///< In a row.

  /// \return what is wrong, for a person, from the reading on that proves it.
  [[nodiscard]] std::optional<std::string> follow(const Temperatures& report);

 private:
  int nozzle_ = 0;  ///< Impossible readings in a row.
  int bed_ = 0;
};

}  // namespace slipstick
