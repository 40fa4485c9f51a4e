#pragma once

#include <optional>

#include "core/base/vec.h"

namespace slipstick {

/// A point of a solid's surface and the unit normal there.
struct SurfacePoint {
  Vec3 at;
  Vec3 normal;
};

/// The ball between two sides.
struct BallBetween {
  double diameter = 0;
  Vec3 centre;
  double squared_cosine = 1;  ///< Of half the angle by which the normals miss being opposite.
};

/// Sides face each other if their normals are opposite to within this, in degrees: enough for a rod
/// of four steps, whose middle no chord needs to hit.
inline constexpr double kFacingDegrees = 30;

/// A pair is left to another axis if the way between its sides is more inclined to the chord than
/// this (a cosine); of three axes one is always at least 1/√3.
inline constexpr double kAlongMin = 0.55;

/// What fits between two sides of a solid or of a void that are seen at the ends of a chord along
/// an axis, where normals point out of what the chord runs through: exactly the thickness of a
/// plate however the chord crosses it, the diameter of a ball or a rod however far from its middle
/// the chord is, the ball that touches both sides of a wedge there.
///
/// \return nothing if the sides do not face each other, or rather along another axis.
/// \pre `first` is not `last`.
[[nodiscard]] std::optional<BallBetween> ball_between(const SurfacePoint& first,
                                                      const SurfacePoint& last);

}  // namespace slipstick
