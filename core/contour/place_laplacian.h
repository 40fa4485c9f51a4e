#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/contour/contour_set.h"

namespace slipstick {

/// \file
/// Ordinary Laplacian smoothing, for comparison with the paper's (section 4, fig. 10 b): nothing
/// keeps a vertex on its stick, and contours shrink.
///
/// Each vertex moves towards the middle of its neighbours, at the rate and until the end that
/// place_smooth.h names.

/// Where the vertices of `loop` go, in cells from the lattice's first node. They may cross each
/// other and samples.
[[nodiscard]] std::vector<Vec2> free_laplacian(const ContourSet& contours,
                                               const ContourSet::Loop& loop);

/// The same, brought back afterwards to the nearest point of each stick, as every contour must be.
void place_laplacian(ContourSet& contours);

}  // namespace slipstick
