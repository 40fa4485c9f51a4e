#include "core/region/facing.h"

namespace slipstick {
namespace {

// The square of cos(kFacingDegrees / 2) = (1 + cos(kFacingDegrees)) / 2.
constexpr double kSquaredCosine = (1 + 0.86602540378443865) / 2;
static_assert(kFacingDegrees == 30);

}  // namespace

std::optional<BallBetween> ball_between(const SurfacePoint& first, const SurfacePoint& last) {
  // Of length 2 cos(half the angle by which the normals miss being opposite).
  const Vec3 across = last.normal - first.normal;
  const double square = dot(across, across);
  if (square < 4 * kSquaredCosine) return {};
  const Vec3 chord = last.at - first.at;
  const double share = dot(chord, across);
  if (share * share < kAlongMin * kAlongMin * square * dot(chord, chord) || share <= 0) return {};
  const double diameter = 2 * share / square;
  const Vec3 sum = last.normal + first.normal;
  return BallBetween{diameter, 0.5 * (first.at + last.at) - (0.25 * diameter) * sum, square / 4};
}

}  // namespace slipstick
