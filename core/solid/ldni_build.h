#pragma once

#include "core/base/result.h"
#include "core/solid/ldni.h"
#include "core/solid/ldni_mend.h"
#include "core/solid/mesh_model.h"

namespace slipstick {

/// What a mesh came to.
struct LdniOfMesh {
  Ldni ldni;
  LdniMended mended;
};

/// The images of a mesh: of each ray, where it goes into the solid that `mesh` is, by winding
/// number or parity, and out of it. Depths are rounded to whole units.
///
/// Rays through corners and along edges and faces are like others, because each triangle counts a
/// half-open range of planes and rows. A ray that does not come out again, behind a crack, is taken
/// from its neighbours. One plane of rays is made at a time, from the triangles that reach it.
///
/// \return kInput if the mesh reaches out of the grid.
[[nodiscard]] Result<LdniOfMesh> ldni_of(const MeshModel& mesh, const LdniGrid& grid);

}  // namespace slipstick
