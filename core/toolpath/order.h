#pragma once

#include <vector>

#include "core/contour/outline.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// Puts beads in the order of printing: island by island, the nearest next; on each the inner
/// perimeters before the outer ones, so that the visible line lies against something, then thin
/// beads, then infill. Open beads may be turned round, closed ones begin at their seam: the vertex
/// farthest towards `seam_degrees`.
///
/// \param outline tells the islands.
[[nodiscard]] std::vector<Bead> in_printing_order(std::vector<Bead> beads, const Outline& outline,
                                                  double seam_degrees);

}  // namespace slipstick
