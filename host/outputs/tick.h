#pragma once

#include <cmath>

namespace slipstick {

/// The distance between ticks of an axis from 0 to `most` that has about `ticks` of them: 1, 2 or 5
/// times a power of ten. \pre Both are positive.
[[nodiscard]] inline double tick_step(double most, int ticks) {
  const double rough = most / ticks;
  const double ten = std::pow(10, std::floor(std::log10(rough)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (times * ten >= rough) return times * ten;
  }
  return 10 * ten;
}

}  // namespace slipstick
