#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vec.h"

namespace slipstick {

/// What a bead is for; decides speed and order.
enum class Role : std::uint8_t {
  kSkirt,
  kOuterPerimeter,
  kInnerPerimeter,
  kThinBead,  ///< One line along the middle of what is too thin for a perimeter.
  kSkin,      ///< Solid infill, top or bottom.
  kInfill,
};

/// One line of plastic laid without stopping, in mm of the print's frame.
struct Bead {
  /// At least 2. A closed bead's last point joins its first, which is not repeated.
  std::vector<Vec2> points;
  /// mm, one for each segment, or a single one for all.
  std::vector<double> widths;
  Role role = Role::kInfill;
  bool closed = false;
};

/// All that is laid on one layer, in the order of printing.
struct LayerToolpaths {
  int layer = 0;
  double top = 0;     ///< mm: height of the nozzle, the upper face of the layer.
  double height = 0;  ///< mm: thickness of the layer.
  std::vector<Bead> beads;
};

}  // namespace slipstick
