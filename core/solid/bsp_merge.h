#pragma once

#include "core/solid/boolean.h"
#include "core/solid/bsp_tree.h"

namespace slipstick {

/// The tree of a Boolean operation: `b` is hung where a leaf of `a` does not decide, without the
/// parts that miss that leaf's cell (Naylor, Amanatides, Thibault 1990).
///
/// Leaves are combined, never computed. A part is left out only if no corner of the cell, cut
/// within `BspModel::kReach`, is surely on its side: what is as thin as the rounding of that may be
/// lost. \return kInput if the tree would be deeper than a tree may be.
[[nodiscard]] Result<BspTree> merged(const BspTree& a, Boolean operation, const BspTree& b);

}  // namespace slipstick
