#pragma once

#include <cstdint>
#include <span>

#include "core/base/result.h"
#include "core/formats/mesh.h"

namespace slipstick {

/// \file
/// What the readers of mesh files share: polygons and the clean-up at the end.

/// Adds the triangles of a polygon as a fan about its first corner; fewer than three corners add
/// none.
void add_polygon(TriangleMesh& mesh, std::span<const std::uint32_t> corners);

/// `value` as an index; what is none becomes one that no mesh has, for `cleaned` to refuse.
[[nodiscard]] std::uint32_t to_vertex_index(double value);

/// Checks a mesh as read, then welds and drops as promised by `read_mesh`.
[[nodiscard]] Result<TriangleMesh> cleaned(const TriangleMesh& raw);

}  // namespace slipstick
