#pragma once

#include <cstdint>

#include "core/formats/mesh.h"

namespace slipstick {

/// What it took to make neighbouring triangles face the same way.
struct Orientation {
  std::int64_t copies = 0;      ///< Triangles left out because the same three corners had one.
  std::int64_t turned = 0;      ///< Triangles turned round.
  std::int64_t unbalanced = 0;  ///< Edges still not run through equally often both ways.
};

/// Makes winding numbers meaningful: leaves a mesh alone whose every edge is run through equally
/// often both ways (copies of faces included). Of others it leaves out copies of faces where that
/// leaves no more edges unbalanced, and turns, in each part joined by edges of two triangles, the
/// smaller number of triangles so that neighbours agree.
[[nodiscard]] Orientation orient(TriangleMesh& mesh);

}  // namespace slipstick
