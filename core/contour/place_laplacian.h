#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/contour/contour_set.h"

namespace slipstick {

/// \file
/// Ordinary Laplacian smoothing, for comparison with the paper's (section 4, fig. 10 b): nothing
/// keeps a vertex on its stick, and contours shrink.
///
/// Each vertex moves by τ = 0.4 of the way to the middle of its neighbours a round, all at once,
/// until they move by less than 10^-3 of a cell on average, or for `kSmoothingRoundsMax` rounds
/// (place_smooth.h).

/// Where the vertices of `loop` go, in cells from the lattice's first node. They may cross each
/// other and samples.
[[nodiscard]] std::vector<Vec2> free_laplacian(const ContourSet& contours,
                                               const ContourSet::Loop& loop);

/// The same, brought back afterwards to the nearest point of each stick, as every contour must be.
void place_laplacian(ContourSet& contours);

}  // namespace slipstick
