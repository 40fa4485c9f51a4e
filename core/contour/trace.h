#pragma once

#include "core/contour/contour_set.h"
#include "core/image/bit_image.h"

namespace slipstick {

/// Topologically faithful contouring (paper, section 3.2 and fig. 7), vertices in the middle of
/// sticks.
///
/// Walks from stick to stick by a local rule instead of a table: the next stick is a function of
/// the two samples ahead, and that function is a permutation of all sticks because the image's
/// border is outside, so every loop closes. Outer boundaries run counter-clockwise, holes
/// clockwise. Loops come in the order of their lowest, then leftmost node.
[[nodiscard]] ContourSet trace(const BitImage& image, Ambiguity ambiguity);

}  // namespace slipstick
