#pragma once

#include <vector>

#include "core/region/distance.h"
#include "core/region/thin.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// Where a line of full width does not fit.
struct ThinRegion {
  const BitImage& region;      ///< What is to be filled.
  const BitImage& kept;        ///< The part of it that full lines take care of.
  const DistanceField& depth;  ///< mm, from the outline.
  double edge = 0;             ///< Depth at which the region begins.
  double line_width = 0.45;    ///< mm
  Ambiguity ambiguity = Ambiguity::kSolid;
};

/// Beads along the middle of what is too thin for a full line, as wide as there is room.
///
/// They and the kept part have exactly the components and holes of the region: every thin neck is
/// bridged, every speck is printed, no hole is closed. Thin walls keep their length, corners leave
/// no spurs. A bead stays within the region, but is never narrower than half a cell of the lattice.
[[nodiscard]] std::vector<Bead> thin_beads(const ThinRegion& thin);

}  // namespace slipstick
