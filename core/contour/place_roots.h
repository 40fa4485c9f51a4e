#pragma once

#include "core/contour/contour_set.h"
#include "core/solid/solid.h"

namespace slipstick {

/// Puts every vertex where the boundary crosses its stick, by bisection of the in/out test down to
/// 1/65536 of a cell. Membership is all it needs, so it serves every kind of solid; where a stick
/// is crossed more than once the crossing that bisection meets is as right as any, topologically.
///
/// \pre `contours` was traced from the image of `section`.
void place_roots(ContourSet& contours, Section& section);

}  // namespace slipstick
