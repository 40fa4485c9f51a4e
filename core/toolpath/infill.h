#pragma once

#include <vector>

#include "core/toolpath/plan_layer.h"
#include "core/toolpath/walls.h"

namespace slipstick {

/// Skins and sparse infill of what lies inside the perimeters.
[[nodiscard]] std::vector<Bead> infill_beads(const LayerInput& input, const DistanceField& depth,
                                             const LineMeasures& lines,
                                             const PrintSettings& settings);

}  // namespace slipstick
