#pragma once

#include <cstddef>

#include "core/image/bit_image.h"

namespace slipstick::test {

/// Counts by flood fill: the slow, obvious oracle of everything topological.

/// Components of the inside nodes; `neighbours` is 4 or 8.
[[nodiscard]] int components(const BitImage& image, int neighbours);
/// Components of the outside nodes but the one around everything.
[[nodiscard]] int holes(const BitImage& image, int neighbours);
/// Pairs of neighbouring nodes of which one is inside.
[[nodiscard]] std::size_t count_sticks(const BitImage& image);

}  // namespace slipstick::test
