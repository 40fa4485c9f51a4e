#pragma once

#include "core/base/affine.h"
#include "core/base/box.h"
#include "core/solid/bsp_tree.h"

namespace slipstick {

/// The box of all inside cells under `map`, up to rounding, as far as they lie in `within`.
[[nodiscard]] Box3 bsp_extent(const BspTree& tree, const Box3& within, const Affine3& map);

}  // namespace slipstick
