#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/formats/mesh.h"

namespace slipstick {

/// Reads text OFF with one vertex or face a line; colours and normals behind them are ignored.
/// The result is as in the file: indices may be wrong, vertices double. \return kInput on damage.
[[nodiscard]] Result<TriangleMesh> read_off(std::string_view bytes);

}  // namespace slipstick
