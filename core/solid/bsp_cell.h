#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/box.h"
#include "core/solid/bsp_tree.h"

namespace slipstick {

/// The value of a plane at a corner that was cut: positive in front of it, and 0 if it is nearer to
/// the plane than the rounding of the cuts that led to the corner can tell.
[[nodiscard]] inline double side_of(const BspPlane& plane, Vec3 p) {
  constexpr double kRounding = 0x1p-44;  // 2^8 units in the last place
  const Vec3 n = plane.normal;
  const double value = dot(n, p) + plane.offset;
  const double reach = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double size =
      (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) * reach + std::abs(plane.offset);
  return std::abs(value) <= kRounding * size ? 0 : value;
}
/// The plane seen from behind.
[[nodiscard]] inline BspPlane flipped(const BspPlane& plane) {
  return {-1 * plane.normal, -plane.offset};
}

/// `polygon` cut off at the plane, what is behind it kept; empty if nothing is strictly behind it.
/// Where an edge is cut is computed from its end behind, so that the result is never in front by
/// more than rounding.
[[nodiscard]] std::vector<Vec3> behind(const std::vector<Vec3>& polygon, const BspPlane& plane);

/// A convex cell of a partition by its faces, in rounded coordinates. It serves to choose and to
/// measure, never to decide what is inside: that is done at points by signs alone.
class BspCell {
 public:
  explicit BspCell(const Box3& box);

  /// The part behind the plane. Empty if there is none.
  [[nodiscard]] BspCell behind_of(const BspPlane& plane) const;

  [[nodiscard]] bool empty() const { return faces_.size() < 4; }
  /// The mean of its corners: within it. \pre Not empty.
  [[nodiscard]] Vec3 middle() const;
  /// Calls `visit(corner)` for all corners, each more than once.
  template <typename Visit>
  void for_each_corner(Visit visit) const {
    for (const auto& face : faces_) {
      for (const Vec3 p : face) visit(p);
    }
  }

 private:
  BspCell() = default;

  std::vector<std::vector<Vec3>> faces_;
};

}  // namespace slipstick
