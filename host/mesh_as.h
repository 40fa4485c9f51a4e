#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/solid/bsp_model.h"
#include "core/solid/ldni_build.h"
#include "core/solid/mesh_model.h"

namespace slipstick {

/// \file
/// A mesh in the paper's other representations.

/// \return kInput as `bsp_of`. The inside is by parity.
[[nodiscard]] Result<std::unique_ptr<BspModel>> bsp_model(const MeshModel& mesh);

/// The images of a mesh, around it. \return kInput as `LdniGrid::around` and `ldni_of`.
[[nodiscard]] Result<LdniOfMesh> ldni_around(const MeshModel& mesh, int resolution);

/// One line for the user if rays were mended, else empty.
[[nodiscard]] std::string warning_of(const LdniMended& mended);

}  // namespace slipstick
