#pragma once

#include <string_view>

namespace slipstick::test {

/// How far a simulated printer may be from a real one: seconds between a line of the host and an
/// answer, and temperatures.
struct Tolerance {
  double seconds = 0.1;
  double share = 0.05;    ///< Of the time that the real printer took, on top.
  double celsius = 0.25;  ///< Of the nozzle: the sensor's noise is three steps of 0.04 °C each way.
  double bed_celsius = 0.25;
  double rise = 0.03;    ///< Of what the temperature is above the room, on top.
  int wait_seconds = 1;  ///< In `W:`.
};

/// Whether `heard` says the same as `expected`: byte for byte, but that temperatures and the time
/// left in `W:` may be off by the tolerance, and powers (`@:`), which follow from them, by any.
[[nodiscard]] bool says_the_same(std::string_view heard, std::string_view expected,
                                 const Tolerance& tolerance);

}  // namespace slipstick::test
