#pragma once

#include <array>
#include <cmath>

#include "core/base/box.h"
#include "core/base/vec.h"

namespace slipstick {

/// One basis function of an adaptively supported RBF solid (Ohtake, Belyaev, Seidel, "3D scattered
/// data approximation with adaptive compactly supported radial basis functions", 2004): a quadric
/// about a centre, and how far it counts.
struct RbfFunction {
  /// Of 1, x, y, z, xx, yy, zz, xy, yz, zx, for points relative to the centre. The constant holds
  /// what the least-squares correction adds.
  using Quadric = std::array<double, 10>;

  Vec3 centre;
  double radius = 1;
  Quadric quadric{};

  friend bool operator==(const RbfFunction&, const RbfFunction&) = default;
};

/// Wendland's weight of a point at squared distance `square` from the centre, which is positive
/// within the support: (1 - r)^4 (4 r + 1). \pre square < radius².
[[nodiscard]] inline double wendland(double square, double radius) {
  const double r = std::sqrt(square) / radius;
  const double rest = 1 - r;
  const double fourth = rest * rest * (rest * rest);
  return fourth * (4 * r + 1);
}

/// The quadric at `d` from the centre. Always in this order: its bits are part of the solid.
[[nodiscard]] inline double quadric_at(const RbfFunction::Quadric& q, Vec3 d) {
  const double x = q[1] + q[4] * d.x + q[7] * d.y;
  const double y = q[2] + q[5] * d.y + q[8] * d.z;
  const double z = q[3] + q[6] * d.z + q[9] * d.x;
  return q[0] + (x * d.x + y * d.y + z * d.z);
}

/// What `quadric_at` gives lies within these, rounding included.
struct RbfRange {
  double low;
  double high;
};
/// Over the points at `middle` ± `half` from the centre. \pre half >= 0.
[[nodiscard]] RbfRange quadric_range(const RbfFunction::Quadric& q, Vec3 middle, Vec3 half);

/// Squared distance of the point of `box` nearest to or farthest from `p`.
[[nodiscard]] double nearest_square(const Box3& box, Vec3 p);
[[nodiscard]] double farthest_square(const Box3& box, Vec3 p);

}  // namespace slipstick
