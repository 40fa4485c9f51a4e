#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipstick {

/// All values that a derivative takes over a box, bounds rounded outwards: two finite ends, or the
/// whole line where nothing is known.
struct Slope {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool known() const { return std::isfinite(low); }
  [[nodiscard]] bool never_zero() const { return low > 0 || high < 0; }
  [[nodiscard]] bool never_falls() const { return low >= 0; }
  [[nodiscard]] bool never_rises() const { return high <= 0; }
};

namespace detail {

// One part in 2^52 is at least the distance to the next double, so that adding it to a rounded
// result and rounding again is a bound of what was rounded.
inline constexpr double kStep = 0x1p-52;

[[nodiscard]] inline Slope checked(double low, double high) {
  if (!(std::abs(low) < std::numeric_limits<double>::infinity() &&
        std::abs(high) < std::numeric_limits<double>::infinity())) {
    return {};
  }
  return {low, high};
}

}  // namespace detail

[[nodiscard]] inline Slope operator-(Slope a) {
  return {-a.high, -a.low};
}

/// Sums of doubles that are so small that a part in 2^52 of them is 0 are exact.
[[nodiscard]] inline Slope operator+(Slope a, Slope b) {
  const double low = a.low + b.low, high = a.high + b.high;
  return detail::checked(low - std::abs(low) * detail::kStep,
                         high + std::abs(high) * detail::kStep);
}

/// Signs survive: what is never negative times what is never negative never is. Walls that stand
/// upright have a slope in z of exactly 0, and should.
[[nodiscard]] inline Slope operator*(Slope a, Slope b) {
  constexpr double kTiny = std::numeric_limits<double>::min();
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  if (!(std::abs(p) + std::abs(q) + std::abs(r) + std::abs(s) <
        std::numeric_limits<double>::infinity())) {
    return {};
  }
  if ((a.low == 0 && a.high == 0) || (b.low == 0 && b.high == 0)) return {0, 0};
  double low = std::min(std::min(p, q), std::min(r, s));
  double high = std::max(std::max(p, q), std::max(r, s));
  low -= std::abs(low) * detail::kStep + kTiny;
  high += std::abs(high) * detail::kStep + kTiny;
  const bool same = (a.low >= 0 && b.low >= 0) || (a.high <= 0 && b.high <= 0);
  const bool opposite = (a.low >= 0 && b.high <= 0) || (a.high <= 0 && b.low >= 0);
  if (same) low = std::max(low, 0.0);
  if (opposite) high = std::min(high, 0.0);
  return {low, high};
}

/// The smallest slope that holds both.
[[nodiscard]] inline Slope hull(Slope a, Slope b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace slipstick
