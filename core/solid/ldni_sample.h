#pragma once

#include "core/base/result.h"
#include "core/solid/ldni.h"
#include "core/solid/solid.h"

namespace slipstick {

/// The images of any solid, by membership: where neighbouring nodes of the grid differ, the place
/// between them to a 65536th of a width, and normals from the differences of depths. What is
/// thinner than a width, and so lies between nodes, is not seen.
///
/// \return kInput if the model reaches out of the grid, has no membership somewhere, or comes to
/// more samples than an `Ldni` holds.
[[nodiscard]] Result<Ldni> ldni_by_sampling(const Model& model, const LdniGrid& grid);

}  // namespace slipstick
