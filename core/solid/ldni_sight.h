#pragma once

#include <array>
#include <span>

#include "core/solid/ldni.h"
#include "core/solid/solid.h"

namespace slipstick {

/// A point in widths of a grid, seen from its origin.
using LdniPoint = std::array<double, 3>;

/// How much farther along its ray than its depth a sample may be taken to lie for a point beside
/// the ray, where its tangent plane says so; in widths.
inline constexpr double kLdniShiftMax = 1.6;
/// How near to a point along its ray a sample must then lie to have a say; in widths. It fades
/// towards that.
inline constexpr double kLdniReach = 1.5;

/// What rays know of a point: a value that is negative inside, and near the surface the distance to
/// it in widths.
///
/// Of each axis the four rays around the point are asked. Each gives the distance of the point to
/// the tangent plane of its nearest sample, negative if the ray, its samples moved along it to
/// where their planes pass the point, is inside there. The value is their mean, weighted by how
/// near the ray is (bilinear), how near the sample is, how little it was moved, and how squarely
/// the ray meets the surface (the fourth power of the cosine). So it changes evenly from ray to
/// ray; walls thinner than a width are kept where rays meet them, and smooth surfaces are off by
/// the square of the width. Where no sample has a say, or only such as are met at a glance, what
/// the rays themselves say on average (-1 inside) decides. All is outside beyond the outermost
/// rays.
///
/// A point farther from the surface than sqrt(2 + 1.6²) widths has the membership of the solid.
class LdniSight {
 public:
  explicit LdniSight(const Ldni& ldni) : ldni_(ldni) {}

  /// At most 0 inside.
  [[nodiscard]] double value(const LdniPoint& p) const;

  /// Of all points p with low <= p <= high, if all rays around them say the same wherever their
  /// samples are moved; asks each of those rays, so for small boxes.
  [[nodiscard]] Cover cover(const LdniPoint& low, const LdniPoint& high) const;

 private:
  struct Sum {
    double weights = 0;
    double values = 0;
    double votes = 0;
  };

  void add_axis(const LdniPoint& p, std::size_t axis, Sum& sum) const;

  const Ldni& ldni_;
};

}  // namespace slipstick
