#pragma once

#include <limits>

#include "core/expr/graph.h"

namespace slipstick {

/// A closed interval that holds every value an expression takes over a box, bounds rounded
/// outwards. What may be NaN somewhere is the whole line and says so.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool may_be_nan = true;

  /// \pre low <= high.
  [[nodiscard]] static Interval of(double low, double high) { return {low, high, false}; }
  /// Anything at all, NaN included.
  [[nodiscard]] static Interval anything() { return {}; }
};

/// All values of `apply(op, a, b)` for a and b in the intervals.
[[nodiscard]] Interval apply(Op op, const Interval& a, const Interval& b);

}  // namespace slipstick
