#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/formats/mesh.h"

namespace slipstick {

/// Reads the polygons of an OBJ file: lines `v` and `f`, the latter with indices from the first
/// vertex (1, 2, …) or from the last so far (-1, -2, …); a `\` at the end of a line goes on on the
/// next. All else (normals, materials, groups, lines, curves) is ignored. The result is as in the
/// file: indices may be wrong. \return kInput, "line N: what", on damage.
[[nodiscard]] Result<TriangleMesh> read_obj(std::string_view bytes);

}  // namespace slipstick
