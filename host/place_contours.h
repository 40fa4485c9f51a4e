#pragma once

#include "core/contour/contour_set.h"
#include "core/job/settings.h"
#include "core/solid/solid.h"

namespace slipstick {

/// Puts every vertex at the place on its stick that `placement` asks for.
/// \pre `contours` was traced from the image of the section of `solid` at `z`.
void place_contours(ContourSet& contours, Placement placement, const Solid& solid, double z);

}  // namespace slipstick
