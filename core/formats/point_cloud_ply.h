#pragma once

#include "core/formats/point_cloud.h"

namespace slipstick {

/// x y z nx ny nz of the vertices of a PLY file as they are; all else is skipped. \return kInput on
/// damage and without normals.
[[nodiscard]] Result<PointCloud> read_ply_points(std::string_view bytes);

}  // namespace slipstick
