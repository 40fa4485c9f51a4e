#pragma once

#include <span>

#include "core/image/bit_image.h"

namespace slipstick {

/// \file
/// Morphology of a solid in space, layer by layer (paper, section 3.3).
///
/// A solid that is a union of balls of radius R, and whose outside is one too, is R-regular, and
/// then its samples tell its topology. Opening by a ball (erosion, then dilation) leaves the union
/// of all balls within the solid, closing (dilation, then erosion) does the same for its outside.
///
/// The balls here are discrete: the nodes at most R from their middle, in mm, layers being nodes as
/// well. Exactly so: opening is idempotent and never adds a node, closing is idempotent and never
/// removes one, both are monotone, and what is opened then closed is at most one node from
/// R-regular wherever opening and closing do not undo each other, which they may at features of 2
/// R.

/// A discrete ball.
struct DiscreteBall {
  double radius = 0;   ///< mm, >= 0
  double spacing = 1;  ///< mm between layers, > 0

  /// Layers above and below that it reaches.
  [[nodiscard]] int reach() const;
};

/// The middle layer of the stack grown or shrunk by the ball. The window has `2 * reach() + 1`
/// layers, lowest first; beyond the images all is outside.
///
/// \pre The images have one grid, and for growing it has room: what would grow onto the outermost
/// ring is cut off.
[[nodiscard]] BitImage dilated(std::span<const BitImage* const> window, const DiscreteBall& ball);
[[nodiscard]] BitImage eroded(std::span<const BitImage* const> window, const DiscreteBall& ball);

}  // namespace slipstick
