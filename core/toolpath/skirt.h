#pragma once

#include <vector>

#include "core/contour/outline.h"
#include "core/job/settings.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// Loops around everything on the first layer, to get the plastic flowing: the convex hull, moved
/// outwards by the skirt's distance, `width` apart, innermost last. Nothing if there is nothing to
/// go around.
[[nodiscard]] std::vector<Bead> skirt_beads(const Outline& outline,
                                            const ToolpathSettings& settings);

}  // namespace slipstick
