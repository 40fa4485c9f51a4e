#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/vec.h"

namespace slipstick {

/// A value for each of X, Y, Z and E.
struct Axes {
  static constexpr std::size_t kCount = 4;

  double x = 0;
  double y = 0;
  double z = 0;
  double e = 0;

  [[nodiscard]] constexpr std::array<double, kCount> all() const { return {x, y, z, e}; }
  [[nodiscard]] constexpr Vec3 xyz() const { return {x, y, z}; }

  friend constexpr bool operator==(const Axes&, const Axes&) = default;
};

constexpr Axes operator-(const Axes& a, const Axes& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z, a.e - b.e};
}
constexpr Axes operator+(const Axes& a, const Axes& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.e + b.e};
}
constexpr Axes operator*(double s, const Axes& a) {
  return {s * a.x, s * a.y, s * a.z, s * a.e};
}
constexpr double dot(const Axes& a, const Axes& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.e * b.e;
}
inline double length(const Axes& a) {
  return std::sqrt(dot(a, a));
}

/// The most that can be had along `direction` when no axis may have more than its `limits`.
inline double limited(double wanted, const Axes& direction, const Axes& limits) {
  const auto d = direction.all();
  const auto l = limits.all();
  for (std::size_t i = 0; i < Axes::kCount; ++i) {
    const double share = std::abs(d[i]);
    if (wanted * share > l[i]) wanted = l[i] / share;
  }
  return wanted;
}

}  // namespace slipstick
