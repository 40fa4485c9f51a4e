#pragma once

#include <vector>

#include "core/solid/rbf_function.h"
#include "core/solid/rbf_points.h"

namespace slipstick {

/// Adds to each function's constant what brings f at the points nearest to zero in the sense of
/// least squares, with a little regularisation (Ohtake et al. 2004, section 4). Each point is held
/// by a support or ignored.
///
/// Solved by conjugate gradients in a fixed order without vector instructions: the same bits on
/// every machine.
[[nodiscard]] std::vector<RbfFunction> corrected(std::vector<RbfFunction> functions,
                                                 const PointIndex& index);

}  // namespace slipstick
