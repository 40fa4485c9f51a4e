#pragma once

#include "core/image/bit_image.h"

namespace slipstick {

/// \file
/// Islands of layers: nodes that hang together, by corners too. Of a print that goes on without one
/// of its objects (cancelled objects, Marlin 2.0.6), an island is left out if all it stands on was.

/// The island of `image` nearest to (x, y) in mm, at most `kIslandReach` away; empty if none is.
[[nodiscard]] BitImage island_at(const BitImage& image, double x, double y);
inline constexpr double kIslandReach = 2;  ///< mm, for fingers.

/// The islands of `image` that lie over some of `cancelled` and over nothing else of `below`.
/// \pre All are on one grid, `cancelled` within `below`.
[[nodiscard]] BitImage standing_on(const BitImage& image, const BitImage& below,
                                   const BitImage& cancelled);

}  // namespace slipstick
