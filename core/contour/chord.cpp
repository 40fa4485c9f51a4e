#include "core/contour/chord.h"

#include <algorithm>
#include <cmath>

#include "core/base/vec.h"

namespace slipstick {
namespace {

Vec2 difference(GridPoint a, GridPoint b) {
  return {static_cast<double>(a.x) - static_cast<double>(b.x),
          static_cast<double>(a.y) - static_cast<double>(b.y)};
}

// The same for a run that turns back on its way, or reaches beyond an end of its edge.
double deviation_of_turning(const LoopView& loop, Run run) {
  const GridPoint a = loop.vertex(run.first);
  const Vec2 edge = difference(loop.vertex(run.last), a);
  const double square = dot(edge, edge);
  double foot = 0;
  double worst = 0;
  for (std::size_t i = run.first + 1; i < run.last; ++i) {
    const Vec2 v = difference(loop.vertex(i), a);
    if (square > 0) foot = std::clamp(dot(v, edge) / square, foot, 1.0);
    const Vec2 away = v - foot * edge;
    worst = std::max(worst, dot(away, away));
  }
  return std::sqrt(worst);
}

}  // namespace

bool stabs(const LoopView& loop, Run run) {
  return stabs(loop, run, loop.vertex(run.first), loop.vertex(run.last));
}

bool stabs(const LoopView& loop, Run run, GridPoint a, GridPoint b) {
  for (std::size_t i = run.first + 1; i < run.last; ++i) {
    if (!crosses(a, b, loop.stick(i))) return false;
  }
  return true;
}

double deviation(const LoopView& loop, Run run) {
  const GridPoint a = loop.vertex(run.first);
  const Vec2 edge = difference(loop.vertex(run.last), a);
  const double square = dot(edge, edge);
  if (!(square > 0)) return deviation_of_turning(loop, run);  // once round
  double farthest = 0;  // squared distance from the edge's line, times `square`
  double foot = 0;      // of the vertex before, times `square`
  for (std::size_t i = run.first + 1; i < run.last; ++i) {
    const Vec2 v = difference(loop.vertex(i), a);
    const double next = dot(v, edge), away = cross(v, edge);
    if (next < foot || next > square) return deviation_of_turning(loop, run);
    foot = next;
    farthest = std::max(farthest, away * away);
  }
  return std::sqrt(farthest / square);
}

}  // namespace slipstick
