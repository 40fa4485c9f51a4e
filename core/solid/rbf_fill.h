#pragma once

#include <vector>

#include "core/formats/point_cloud.h"
#include "core/solid/rbf_function.h"
#include "core/solid/rbf_points.h"

namespace slipstick {

/// Basis functions for the space between the surface's, where they say nothing or something wrong.
///
/// Outside of all supports is outside, so without these a solid would be a shell about its surface;
/// and at the rim of a support, a quadric that bends away from the points makes a phantom. An
/// octree of the points' box looks for both: a cell that no point is near, and where f is not on
/// the side that the winding number of the points says, gets a ball of its own, which reaches no
/// point and so leaves the surface as it is. In holes among the points, where the winding number is
/// between, the ball carries its slope, so that the hole is closed smoothly.
[[nodiscard]] std::vector<RbfFunction> fill_between(const std::vector<RbfFunction>& surface,
                                                    const PointCloud& cloud,
                                                    const PointIndex& index);

}  // namespace slipstick
