#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/solid/bsp_model.h"
#include "core/solid/ldni_build.h"
#include "core/solid/ldni_model.h"
#include "core/solid/mesh_model.h"

namespace slipstick {

/// \file
/// A mesh in the paper's other representations.

/// \return kInput as `bsp_of`. The inside is by parity.
[[nodiscard]] Result<std::unique_ptr<BspModel>> bsp_model(const MeshModel& mesh);

struct LdniLoaded {
  std::unique_ptr<LdniModel> model;
  std::string warning;  ///< Empty, or what was mended.
};

/// \return kInput as `LdniGrid::around` and `ldni_of`.
[[nodiscard]] Result<LdniLoaded> ldni_model(const MeshModel& mesh, int resolution);
[[nodiscard]] Result<LdniLoaded> ldni_model(const MeshModel& mesh, const LdniGrid& grid);

}  // namespace slipstick
