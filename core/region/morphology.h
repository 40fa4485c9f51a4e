#pragma once

#include "core/image/bit_image.h"

namespace slipstick {

/// `image` grown by `radius` nodes in every direction, diagonals included, as far as the window's
/// inner part.
[[nodiscard]] BitImage dilated(const BitImage& image, int radius);

}  // namespace slipstick
