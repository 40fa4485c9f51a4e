#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace slipstick {

/// Triangles over shared vertices, in the file's own units; of 3MF, in millimetres.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// Limits of a mesh file; what is larger is refused. Memory is bounded by the bytes, whatever they
/// say.
inline constexpr std::size_t kMeshBytesMax = std::size_t{1} << 31;
inline constexpr std::size_t kMeshElementsMax = std::size_t{1} << 26;
/// Coordinates beyond this are taken for damage.
inline constexpr double kMeshCoordinateMax = 1e9;

/// Reads STL, OBJ, PLY, OFF or 3MF, text or binary, by `extension` ("stl", any case).
///
/// Vertices of equal coordinates are one vertex, every vertex is used, every coordinate is finite,
/// no triangle uses a vertex twice and there is at least one triangle. Polygons become fans, which
/// leaves parity as it is even where they are not convex. No other file is read: material libraries
/// are ignored.
///
/// \return kInput for anything else; the message says what is wrong where, not which file.
[[nodiscard]] Result<TriangleMesh> read_mesh(std::string_view bytes, std::string_view extension);

}  // namespace slipstick
