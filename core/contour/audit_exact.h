#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/vec.h"

namespace slipstick::audit_exact {

/// \file
/// Exact plane geometry for the audit: points in whole numbers of 2^-40 mm.

__extension__ typedef __int128 Wide;  // what ISO C++ has no name for

inline constexpr double kUnitsPerMm = 0x1p40;
inline constexpr double kReachMax =
    10000;  // mm; then differences stay below 2^55, products below 2^111

struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

[[nodiscard]] inline bool representable(Vec2 p) {
  return std::abs(p.x) <= kReachMax && std::abs(p.y) <= kReachMax;  // false for NaN
}

/// \pre `representable(p)`.
[[nodiscard]] inline Point point(Vec2 p) {
  return {std::llround(p.x * kUnitsPerMm), std::llround(p.y * kUnitsPerMm)};
}

[[nodiscard]] inline Vec2 mm(Point p) {
  return {static_cast<double>(p.x) / kUnitsPerMm, static_cast<double>(p.y) / kUnitsPerMm};
}

/// Twice the signed area of the triangle: positive where it turns left.
[[nodiscard]] constexpr Wide turn(Point a, Point b, Point c) {
  return Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x);
}

[[nodiscard]] constexpr int sign(Wide w) {
  return w > 0 ? 1 : w < 0 ? -1 : 0;
}

/// Whether `p`, known to be on the line through `a` and `b`, lies between them, ends included.
[[nodiscard]] constexpr bool between(Point a, Point b, Point p) {
  const auto within = [](std::int64_t u, std::int64_t v, std::int64_t w) {
    return (u <= w && w <= v) || (v <= w && w <= u);
  };
  return within(a.x, b.x, p.x) && within(a.y, b.y, p.y);
}

/// Whether two closed segments have a point in common.
[[nodiscard]] constexpr bool touch(Point a, Point b, Point c, Point d) {
  const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d));
  const int cda = sign(turn(c, d, a)), cdb = sign(turn(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
         (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

}  // namespace slipstick::audit_exact
