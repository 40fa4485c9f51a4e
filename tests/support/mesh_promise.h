#pragma once

#include "core/formats/mesh.h"

namespace slipstick {

/// Checks what `read_mesh` promises of `mesh`.
void check_mesh_promise(const TriangleMesh& mesh);

}  // namespace slipstick
