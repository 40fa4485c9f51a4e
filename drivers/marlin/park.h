#pragma once

#include <vector>

#include "drivers/marlin/line.h"
#include "drivers/marlin/print_state.h"

namespace slipstick {

/// \file
/// Leaving a print for a while, and coming back to exactly where it was left.

/// Where a nozzle waits, in the machine's coordinates, and how it gets there.
struct ParkingPlace {
  static constexpr double kLift = 10;  ///< mm above the nozzle and all that was laid.

  double x = 0;                 ///< mm
  double y = 0;                 ///< mm
  double height_max = 0;        ///< mm: the machine goes no higher.
  double retraction = 0;        ///< mm of filament.
  double retraction_speed = 0;  ///< mm/s, this and the following.
  double travel_speed = 0;
  double lift_speed = 0;
};

/// Retracts, lifts and parks; temperatures stay, and so does the power of the motors, however long
/// it takes. Ends when the nozzle is there. Where coordinates may not be the machine's the nozzle
/// is lifted only; where its place is not known it stays, and there are no lines.
[[nodiscard]] std::vector<Line> parking_lines(const PrintState& state, const ParkingPlace& place);

/// The way back: waits until it is as hot as `state` wants it, then restores place, filament, feed
/// rate, fan and modes.
[[nodiscard]] std::vector<Line> returning_lines(const PrintState& state, const ParkingPlace& place);

}  // namespace slipstick
