#pragma once

#include <vector>

#include "sim/defect.h"
#include "sim/pixel_image.h"
#include "sim/regions.h"

namespace slipstick {

/// \file
/// Where material is missing along the contours, and where it lies on nothing.

/// Those regions of `image` (8-connected) in which a square of `side` pixels has room, one defect
/// each, its place inside the thickest part. \pre `side` is odd, `image` has an empty ring.
[[nodiscard]] std::vector<Defect> thick_regions(const PixelImage& image, int side, DefectKind kind);

/// The pixels of `solid` that are at most `depth` steps from its border.
[[nodiscard]] PixelImage rim_of(const PixelImage& solid, int depth);

/// What of a layer lies on nothing.
struct Hanging {
  PixelImage wrong;   ///< In pieces that nothing holds, or where no solid is wanted.
  PixelImage wanted;  ///< Bridges and overhangs that the solid asks for and something holds.
};

/// \param deposit All that was laid in the layer; \param support what lies below, infill's cells
/// taken as closed; \param reach how many pixels a bead may stand out over it.
/// \pre All in one frame.
[[nodiscard]] Hanging hanging(const PixelImage& deposit, const PixelImage& support,
                              const PixelImage& solid, int reach);

/// The largest square of set pixels.
struct LargestSquare {
  int side = 0;  ///< Pixels; 0 where none is set.
  Vec2 middle;
};
[[nodiscard]] LargestSquare largest_square(const PixelImage& image);

/// The middle of the longest of `runs`. \pre There is one.
[[nodiscard]] Vec2 middle_of_longest(const PixelFrame& frame, std::span<const PixelRun> runs);

}  // namespace slipstick
