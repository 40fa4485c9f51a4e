#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// Shorter moves are kept back by Marlin and made together with the next, which may be a travel:
/// six steps of 80 to the millimetre (MIN_STEPS_PER_SEGMENT), on both axes.
inline constexpr double kMoveMin = 0.08;  // mm

/// A straight piece of a bead: where to, and how much plastic on the way.
struct Piece {
  Vec2 to;
  double volume = 0;  ///< mm³
};

/// A bead as moves.
struct Moves {
  Vec2 from;
  std::vector<Piece> pieces;
};

/// The moves of `bead` in a layer `height` high, none shorter than `kMoveMin`: shorter ones are
/// joined, and a bead that is shorter as a whole is stretched. The plastic stays the same.
[[nodiscard]] Moves resolvable_moves(const Bead& bead, double height);

}  // namespace slipstick
