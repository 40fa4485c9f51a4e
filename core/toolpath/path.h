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

/// A bead that is as good as a point, as wide as `width`. It has a length, for without one it would
/// have no plastic: half its width, which makes it about as much as a disc holds.
[[nodiscard]] inline Bead dot(Vec2 at, double width, Role role) {
  const Vec2 half{width / 4, 0};
  return {{at - half, at + half}, {width}, role, false};
}

/// All that is laid on one layer, in the order of printing.
struct LayerToolpaths {
  int layer = 0;
  double top = 0;     ///< mm: height of the nozzle, the upper face of the layer.
  double height = 0;  ///< mm: thickness of the layer.
  std::vector<Bead> beads;
};

}  // namespace slipstick
