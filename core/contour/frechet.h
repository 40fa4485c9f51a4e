#pragma once

#include <span>
#include <vector>

#include "core/contour/chord.h"

namespace slipstick {

/// A vertex that an outline keeps of a loop: on which stick, and where on it.
struct Kept {
  std::size_t index = 0;
  Place place;
};

/// For each vertex of `loop`, in 1/65536 of a cell, how far the polygon through `kept` is at most
/// from the loop there: the largest entry is an upper bound of their Fréchet distance.
///
/// Partners run forward on both: a skipped vertex goes with the foot of its perpendicular, as far
/// as feet advance; a moved vertex with the nearer of its feet on the two edges that meet there,
/// and the corner between with the nearest point of the piece of the loop on its other side. \pre
/// `kept` ascends and has at least 3.
void frechet_bounds(const LoopView& loop, std::span<const Kept> kept, std::vector<double>& bounds);

}  // namespace slipstick
