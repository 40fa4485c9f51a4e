#pragma once

#include <vector>

#include "core/base/vec.h"

namespace slipstick {

/// A straight piece of infill from one border of the region to another.
struct RasterLine {
  Vec2 from;
  Vec2 to;
};

struct RasterOptions {
  double spacing = 0;  ///< mm between lines; infinite for none but those that connect.
  double angle = 45;   ///< Degrees.
};

/// Lines of a rectilinear infill, clipped to what `polygons` enclose (even-odd), in the order of
/// printing, to and fro. Lines lie on the same places for any region, so they stack from layer to
/// layer.
[[nodiscard]] std::vector<RasterLine> raster(const std::vector<std::vector<Vec2>>& polygons,
                                             const RasterOptions& options);

/// Lines of the same kind, as few as needed so that they and those of `raster` leave no polygon
/// unconnected with the others of its component: without them a hole's walls may stand alone in a
/// sparse infill.
[[nodiscard]] std::vector<RasterLine> connecting_lines(
    const std::vector<std::vector<Vec2>>& polygons, const RasterOptions& options);

}  // namespace slipstick
