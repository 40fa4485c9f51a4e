#pragma once

#include <cstddef>

#include "core/contour/contour_set.h"

namespace slipstick {

/// Whether the segment from `a` to `b` crosses the open `stick` in the direction of the contour:
/// the test of proposition 5, exact. Touching an end of the stick is a miss.
[[nodiscard]] constexpr bool crosses(GridPoint a, GridPoint b, Stick stick) {
  const GridPoint inside = along(stick, 0);
  const GridPoint outside = along(stick, SliceGrid::kUnitsPerCell);
  return cross(inside, outside, a) < 0 && cross(inside, outside, b) > 0 &&
         cross(a, b, inside) > 0 && cross(a, b, outside) < 0;
}

/// One loop of a contour set, vertices and sticks counted round and round.
class LoopView {
 public:
  LoopView(const ContourSet& contours, const ContourSet::Loop& loop)
      : sticks_(contours.sticks(loop)), places_(contours.places(loop)) {}

  [[nodiscard]] std::size_t size() const { return sticks_.size(); }
  [[nodiscard]] Stick stick(std::size_t i) const { return sticks_[wrapped(i)]; }
  [[nodiscard]] Place place(std::size_t i) const { return places_[wrapped(i)]; }
  [[nodiscard]] GridPoint vertex(std::size_t i) const {
    const std::size_t k = wrapped(i);
    return position(sticks_[k], places_[k]);
  }

 private:
  [[nodiscard]] std::size_t wrapped(std::size_t i) const {
    return i < sticks_.size() ? i : i % sticks_.size();
  }

  std::span<const Stick> sticks_;
  std::span<const Place> places_;
};

/// A run of edges of a loop, from vertex `first` to vertex `last`; first < last <= first + size.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Whether one edge may stand for `run`: it crosses every stick between (proposition 5). Then all
/// other edges of the layer may be replaced likewise at the same time, and the result is free of
/// self-intersection and separates the same samples: edges of different runs stay in disjoint
/// corridors.
[[nodiscard]] bool stabs(const LoopView& loop, Run run);
/// The same for an edge from `a` to `b`, which may lie elsewhere on the first and last stick.
[[nodiscard]] bool stabs(const LoopView& loop, Run run, GridPoint a, GridPoint b);

/// An upper bound, in 1/65536 of a cell, of the Fréchet distance between `run` and the edge joining
/// its ends: the largest distance of a vertex from its partner on the edge, partners being the feet
/// of the perpendiculars as far as they advance.
[[nodiscard]] double deviation(const LoopView& loop, Run run);

}  // namespace slipstick
