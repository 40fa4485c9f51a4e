#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/formats/mesh.h"

namespace slipstick {

/// Reads STL, by its `extension`, with the library assimp and none of its post-processing, which
/// trusts indices. (In version 5.2.5 its readers of OBJ and PLY crash on damaged files, the latter
/// also on sound ones whose binary part begins with a line feed, and the one of OFF takes as much
/// memory as the file asks for, so those are our own.) The result is as in the file: vertices
/// double, coordinates perhaps not finite.
[[nodiscard]] Result<TriangleMesh> read_with_assimp(std::string_view bytes,
                                                    const std::string& extension);

}  // namespace slipstick
