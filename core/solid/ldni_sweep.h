#pragma once

#include <cstddef>
#include <vector>

#include "core/solid/ldni.h"
#include "core/solid/mesh_model.h"

namespace slipstick {

/// The rays of one axis through a mesh.
struct LdniSwept {
  LdniRays rays;
  std::vector<std::size_t> open;  ///< Rays that go in and do not come out, left empty; rising.
};

/// \pre The mesh lies within the grid.
[[nodiscard]] LdniSwept swept(const MeshModel& mesh, const LdniGrid& grid, std::size_t axis);

}  // namespace slipstick
