#pragma once

#include <span>

#include "core/base/affine.h"
#include "core/solid/rbf_function.h"

namespace slipstick {

/// The box of {f <= 0} under `map`, found by halving boxes that are not certainly outside: at most
/// about a thousandth of its size too large and never too small. Empty if all is outside.
[[nodiscard]] Box3 rbf_extent(std::span<const RbfFunction> functions, const Affine3& map);

}  // namespace slipstick
