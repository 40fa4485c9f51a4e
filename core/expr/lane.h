#pragma once

#include <cmath>

namespace slipstick {

/// \file
/// A double as a vector of one lane, for kernels written once for all widths.

inline double choose(bool mask, double yes, double no) {
  return mask ? yes : no;
}
inline double absolute_of(double x) {
  return std::abs(x);
}

}  // namespace slipstick
