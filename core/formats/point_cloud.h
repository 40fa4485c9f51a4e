#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace slipstick {

/// Points of a surface and its outward unit normals there.
struct PointCloud {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
};

/// Fewer points than this are no surface.
inline constexpr std::size_t kCloudPointsMin = 16;
inline constexpr std::size_t kCloudPointsMax = std::size_t{1} << 24;

/// Reads points with normals by `extension`, any case:
/// - "xyz": x y z nx ny nz a line; empty lines and those that begin with # are skipped;
/// - "pwn": the same, or Ohtake's order: their number, all points, all normals;
/// - "ply": vertices with the properties x y z nx ny nz; faces are not read.
///
/// Every coordinate is finite and at most `kMeshCoordinateMax`; normals have length 1; the points
/// are not all one. Memory is a multiple of the bytes.
/// \return kInput for anything else; the message says what is wrong where, not which file.
[[nodiscard]] Result<PointCloud> read_point_cloud(std::string_view bytes,
                                                  std::string_view extension);

/// Whether a PLY file has vertices and no faces.
[[nodiscard]] bool ply_is_point_cloud(std::string_view bytes);

}  // namespace slipstick
