#pragma once

#include <cstddef>

#include "core/contour/contour_set.h"

namespace slipstick::test {

/// No polygons through the windows of `tolerance` mm about the places of `contours` have fewer
/// edges than this.
///
/// Every edge of such a polygon is a line that crosses the windows of the sticks it skips, so the
/// sticks of a loop fall into as many runs as the polygon has edges, each stabbed by one line. The
/// longest runs that can be stabbed, one after another, from the best start within the first, are
/// the fewest.
[[nodiscard]] std::size_t fewest_edges_bound(const ContourSet& contours, double tolerance);

}  // namespace slipstick::test
