#pragma once

#include "core/solid/ldni.h"

namespace slipstick {

/// Replaces normals that the samples of neighbouring rays belie: those of slivers and of noise,
/// whose tangent planes lead astray. For each sample the normals tried are its own, those of the
/// four samples beside it, and that of their differences; it keeps its own unless another foretells
/// the depths beside it at least twice as well.
[[nodiscard]] LdniRays settled(const LdniRays& rays, const LdniGrid& grid, std::size_t axis);

/// The same rays with normals that follow from the differences of depth from ray to ray alone, for
/// solids of which only membership is known; steep where no sample lies beside one.
[[nodiscard]] LdniRays with_normals_of_differences(const LdniRays& rays, const LdniGrid& grid,
                                                   std::size_t axis);

}  // namespace slipstick
