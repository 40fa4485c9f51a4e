#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "core/base/vec.h"

namespace slipstick {

/// A piece of a mesh's outline in a plane. \pre low.y < high.y.
struct OutlineSegment {
  Vec2 low;
  Vec2 high;
  int turn = 1;  ///< 1 where the outline runs upwards, -1 where it runs downwards.
};

/// What a triangle, counter-clockwise seen from outside, has in the plane at `z`: nothing where all
/// its corners are above it or none is, or where the cut is level.
///
/// A corner is above if it is strictly above. The point of an edge is computed upwards, so that all
/// triangles at the edge get the very same point and the cuts of a closed mesh close exactly.
[[nodiscard]] inline std::optional<OutlineSegment> cut_of(const std::array<Vec3, 3>& p, double z) {
  const std::array<bool, 3> above{p[0].z > z, p[1].z > z, p[2].z > z};
  if (above[0] == above[1] && above[1] == above[2]) return {};
  const auto cut = [&](Vec3 from, Vec3 to) -> Vec2 {
    const Vec3 low = from.z < to.z ? from : to, high = from.z < to.z ? to : from;
    const double share = (z - low.z) / (high.z - low.z);
    return {low.x + share * (high.x - low.x), low.y + share * (high.y - low.y)};
  };
  // One corner is on its own, with two cut edges. Seen from outside, the cut runs from a to b if it
  // is above, else back.
  const std::size_t lone = above[1] == above[2] ? 0 : above[0] == above[2] ? 1 : 2;
  const Vec2 a = cut(p[lone], p[(lone + 1) % 3]), b = cut(p[lone], p[(lone + 2) % 3]);
  const int turn = above[lone] ? 1 : -1;
  if (a.y < b.y) return OutlineSegment{a, b, turn};
  if (b.y < a.y) return OutlineSegment{b, a, -turn};
  return {};
}

/// Where a segment meets the row at `y`. Clamped, so that a segment that lies beside a point is
/// counted as lying beside it in spite of rounding. \pre The row is one of low.y <= y < high.y,
/// those that the segment counts in.
[[nodiscard]] inline double crossing_x(const OutlineSegment& s, double y) {
  const double share = (y - s.low.y) / (s.high.y - s.low.y);
  const double x = s.low.x + share * (s.high.x - s.low.x);
  return std::clamp(x, std::min(s.low.x, s.high.x), std::max(s.low.x, s.high.x));
}

/// Which crossings make a point inside: those at or to the left of it in its row.
enum class Winding : std::uint8_t {
  kNonzero,  ///< Where their turns do not add up to 0: overlapping shells are one solid.
  kParity,   ///< Where their number is odd: overlaps are void, orientation does not matter.
};

/// What a crossing counts.
[[nodiscard]] constexpr int counted(Winding winding, int turn) {
  return winding == Winding::kNonzero ? turn : 1;
}

/// What crossings that count up to `turns` come to.
[[nodiscard]] constexpr bool is_inside(Winding winding, int turns) {
  return winding == Winding::kNonzero ? turns != 0 : turns % 2 != 0;
}

}  // namespace slipstick
