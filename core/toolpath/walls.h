#pragma once

#include <vector>

#include "core/job/settings.h"
#include "core/region/distance.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// Measures of the lines of one layer, mm.
struct LineMeasures {
  double width = 0;
  double spacing = 0;  ///< Between neighbouring lines.
  int perimeters = 0;
  double overlap = 0;    ///< Of infill into the innermost perimeter, of a line width.
  double tolerance = 0;  ///< By which a perimeter may be off, and by which all of them lie deeper:
                         ///< no bead reaches beyond the outline, so none closes a narrow gap.

  /// How deep the middle of perimeter `k` lies.
  [[nodiscard]] double centre(int k) const { return edge(k) + width / 2 + tolerance; }
  /// How deep what lies inside perimeter k - 1 begins.
  [[nodiscard]] double edge(int k) const { return k * spacing; }
  /// How deep the ends of infill lines lie.
  [[nodiscard]] double infill_edge() const { return edge(perimeters) + (0.5 - overlap) * width; }
};

[[nodiscard]] LineMeasures measures_of(const PrintSettings& settings, int layer, double height);

/// The perimeters of a layer, outermost first, and the thin beads between and beside them.
[[nodiscard]] std::vector<Bead> wall_beads(const BitImage& image, const DistanceField& depth,
                                           const LineMeasures& lines,
                                           const SlicingSettings& slicing);

}  // namespace slipstick
