#include "core/toolpath/skirt.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/elementary.h"

namespace slipstick {
namespace {

// Andrew's monotone chain, counter-clockwise.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull;
  const auto add = [&hull](Vec2 p, std::size_t fixed) {
    while (hull.size() >= fixed + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vec2 p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.pop_back();
  return hull;
}

// The hull moved outwards by `by`, corners rounded by arcs of about a millimetre.
std::vector<Vec2> outwards(const std::vector<Vec2>& hull, double by) {
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 p = hull[i];
    const Vec2 in = p - hull[(i + hull.size() - 1) % hull.size()];
    const Vec2 out = hull[(i + 1) % hull.size()] - p;
    const double from = arc_tangent(-in.x, in.y);
    double turn = arc_tangent(-out.x, out.y) - from;
    if (turn < 0) turn += 2 * std::numbers::pi;
    const int steps = static_cast<int>(std::ceil(turn * by)) + 1;
    for (int k = 0; k <= steps; ++k) {
      const double angle = from + turn * k / steps;
      result.push_back(p + by * Vec2{cosine(angle), sine(angle)});
    }
  }
  return result;
}

}  // namespace

std::vector<Bead> skirt_beads(const Outline& outline, const ToolpathSettings& settings) {
  std::vector<Vec2> points;
  for (const Outline::Loop& loop : outline.loops()) {
    if (loop.depth != 0) continue;
    for (const GridPoint p : loop.points) points.push_back(outline.mm(p));
  }
  if (points.empty()) return {};
  const std::vector<Vec2> hull = convex_hull(std::move(points));
  const double width = settings.first_layer_line_width;
  std::vector<Bead> beads;
  for (int i = settings.skirt_loops - 1; i >= 0; --i) {
    const double by = settings.skirt_distance + width / 2 + i * width;
    beads.push_back({outwards(hull, by), {width}, Role::kSkirt, true});
  }
  return beads;
}

}  // namespace slipstick
