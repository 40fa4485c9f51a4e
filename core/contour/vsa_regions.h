#pragma once

#include <cstddef>
#include <vector>

#include "core/contour/chord.h"

namespace slipstick {

/// The regions into which `simplify_vsa` segments a loop before it verifies them (paper, section
/// 5.1): one for `alpha` edges, at least three.
///
/// \param alpha the paper's clustering ratio; below 1 counts as 1.
/// \return the first edges of the regions, ascending; each runs up to the next first.
[[nodiscard]] std::vector<std::size_t> vsa_regions(const LoopView& loop, int alpha);

}  // namespace slipstick
