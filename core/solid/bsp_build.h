#pragma once

#include "core/base/result.h"
#include "core/formats/mesh.h"
#include "core/solid/bsp_tree.h"

namespace slipstick {

/// The tree of a mesh. Large cells are halved by planes across their longest side, which keeps the
/// depth near the logarithm of the number of triangles; cells of few triangles are split by the
/// planes of the triangles themselves, the one that cuts the fewest others first.
///
/// A corner is in front of a plane or behind it if its computed value is surely so, on it if
/// rounding cannot tell: what is coplanar in the file is so here, and no cell is thinner than
/// rounding. What a cell is is not deduced from its splits but asked of the mesh, by the parity of
/// `MeshModel`, at the middle of the cell, so that rounding can only matter within cells as thin as
/// it; siblings that are the same are one.
///
/// \return kInput if the mesh has open edges, and so no inside, or if its faces lie so close
/// together that a path of the tree would be longer than `depth_max`.
[[nodiscard]] Result<BspTree> bsp_of(const TriangleMesh& mesh,
                                     int depth_max = BspTree::kDepthMax - 8);

}  // namespace slipstick
