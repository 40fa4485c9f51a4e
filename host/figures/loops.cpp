#include "host/figures/loops.h"

#include "core/contour/chord.h"
#include "core/contour/place_laplacian.h"

namespace slipstick {

DrawnLoop loop_in_mm(const ContourSet& contours, const ContourSet::Loop& loop) {
  const SliceGrid& grid = contours.grid();
  const LoopView view(contours, loop);
  DrawnLoop points;
  points.reserve(view.size());
  for (std::size_t i = 0; i < view.size(); ++i) {
    const GridPoint p = view.vertex(i);
    points.push_back({grid.x_of(p.x), grid.y_of(p.y)});
  }
  return points;
}

std::vector<DrawnLoop> loops_in_mm(const ContourSet& contours) {
  std::vector<DrawnLoop> loops;
  for (const ContourSet::Loop& loop : contours.loops()) {
    loops.push_back(loop_in_mm(contours, loop));
  }
  return loops;
}

std::vector<DrawnLoop> loops_in_mm(const Outline& outline) {
  std::vector<DrawnLoop> loops;
  for (const Outline::Loop& loop : outline.loops()) {
    loops.emplace_back();
    for (const GridPoint p : loop.points) loops.back().push_back(outline.mm(p));
  }
  return loops;
}

std::vector<DrawnLoop> free_loops_in_mm(const ContourSet& contours) {
  const SliceGrid& grid = contours.grid();
  const Vec2 first{grid.node_x(0), grid.node_y(0)};
  std::vector<DrawnLoop> loops;
  for (const ContourSet::Loop& loop : contours.loops()) {
    loops.emplace_back();
    for (const Vec2 cells : free_laplacian(contours, loop)) {
      loops.back().push_back(first + grid.width() * cells);
    }
  }
  return loops;
}

}  // namespace slipstick
