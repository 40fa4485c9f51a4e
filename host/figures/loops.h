#pragma once

#include <vector>

#include "core/contour/contour_set.h"
#include "core/contour/outline.h"

namespace slipstick {

/// \file
/// Contours as polygons in mm, to be drawn.

using DrawnLoop = std::vector<Vec2>;

[[nodiscard]] DrawnLoop loop_in_mm(const ContourSet& contours, const ContourSet::Loop& loop);
[[nodiscard]] std::vector<DrawnLoop> loops_in_mm(const ContourSet& contours);
[[nodiscard]] std::vector<DrawnLoop> loops_in_mm(const Outline& outline);

/// After `free_laplacian`: off their sticks.
[[nodiscard]] std::vector<DrawnLoop> free_loops_in_mm(const ContourSet& contours);

}  // namespace slipstick
