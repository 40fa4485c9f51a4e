#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/vec.h"
#include "core/contour/stick.h"
#include "core/image/grid.h"

namespace slipstick {

/// The finished contours of one layer: closed polygons, free of self-intersection and disjoint,
/// that separate exactly the inside samples from the outside ones.
///
/// Even depth runs counter-clockwise, odd clockwise: the solid lies on the left. Made by the
/// functions of simplify.h only, which prove what is said here; `audit` checks it from outside.
class Outline {
 public:
  struct Loop {
    std::vector<GridPoint> points;  ///< At least 3, the first not repeated.
    int depth = 0;                  ///< 0 outer boundary, 1 hole, 2 island in it, …
  };

  [[nodiscard]] const SliceGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<Loop>& loops() const { return loops_; }
  [[nodiscard]] std::size_t edges() const {
    std::size_t sum = 0;
    for (const Loop& loop : loops_) sum += loop.points.size();
    return sum;
  }
  /// Exact, in mm of the print's frame.
  [[nodiscard]] Vec2 mm(GridPoint p) const { return {grid_.x_of(p.x), grid_.y_of(p.y)}; }

 private:
  friend class OutlineBuilder;
  explicit Outline(const SliceGrid& grid) : grid_(grid) {}

  SliceGrid grid_;
  std::vector<Loop> loops_;
};

}  // namespace slipstick
