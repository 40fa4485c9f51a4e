#pragma once

#include "core/contour/contour_set.h"
#include "core/solid/solid.h"

namespace slipstick {

/// Puts every vertex where the boundary crosses its stick, to 1/65536 of a cell: by values of f
/// where the section has them (`Bracket`), else by bisection of the in/out test, so it serves every
/// kind of solid. Where a stick is crossed once both give the same place; where it is crossed more
/// often the crossing found is as right as any, topologically, and always the same one.
///
/// \pre `contours` was traced from the image of `section`.
void place_roots(ContourSet& contours, Section& section);

}  // namespace slipstick
