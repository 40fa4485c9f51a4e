#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/formats/mesh.h"

namespace slipstick {

/// Reads PLY 1.0, text or binary of either byte order: x, y, z of its vertices and the polygons of
/// its faces; all else is skipped. The result is as in the file: indices may be wrong, vertices
/// double. \return kInput on damage.
[[nodiscard]] Result<TriangleMesh> read_ply(std::string_view bytes);

}  // namespace slipstick
