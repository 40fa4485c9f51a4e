#pragma once

#include "core/contour/contour_set.h"
#include "core/contour/outline.h"
#include "core/region/distance.h"

namespace slipstick {

/// Puts each vertex where `field` would pass `level` if it were linear along the stick; in the
/// middle where the stick does not cross that level (a border of the image that is no level of the
/// field).
void place_at_level(ContourSet& contours, const DistanceField& field, double level);

/// The contours of `image`, a set of nodes at least `level` deep or a part of one, within
/// `tolerance` mm of where the level is: insets that never cross themselves or each other.
[[nodiscard]] Outline level_outline(const BitImage& image, const DistanceField& field, double level,
                                    double tolerance, Ambiguity ambiguity);

/// All loops of an outline as points in mm.
[[nodiscard]] std::vector<std::vector<Vec2>> polygons_of(const Outline& outline);

}  // namespace slipstick
