#pragma once

#include "core/base/result.h"
#include "core/solid/boolean.h"
#include "core/solid/ldni.h"

namespace slipstick {

/// A Boolean operation, ray by ray, on intervals; exact, for depths are integers. What is left at
/// one depth of both (faces that touch) has no void between, and nothing as thin as a point is
/// left.
///
/// \return kInput if the two are not on one grid, or if more samples came out than an `Ldni` holds.
[[nodiscard]] Result<Ldni> merged(const Ldni& a, Boolean operation, const Ldni& b);

}  // namespace slipstick
