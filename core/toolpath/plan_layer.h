#pragma once

#include "core/contour/outline.h"
#include "core/image/bit_image.h"
#include "core/job/settings.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// All that one layer's toolpaths depend on.
struct LayerInput {
  int layer = 0;
  double top = 0;     ///< mm
  double height = 0;  ///< mm
  const BitImage& image;
  const Outline& outline;  ///< Of `image`.
  const BitImage& above;   ///< What the layers of a top skin have in common.
  const BitImage& below;   ///< Likewise of a bottom skin.
};

/// Perimeters, thin beads, skins and infill of a layer, in the order of printing.
///
/// What is laid has the topology of the contours by construction: a perimeter is a level of the
/// distance to the outline, what no perimeter reaches is worn away to lines of the same topology,
/// each ring overlaps the one around it, and infill connects what would stand alone
/// (core/README.md).
[[nodiscard]] LayerToolpaths plan_layer(const LayerInput& input, const PrintSettings& settings);

}  // namespace slipstick
