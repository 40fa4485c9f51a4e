#include "core/contour/prefix_moments.h"

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

constexpr double kCell = 1.0 / static_cast<double>(SliceGrid::kUnitsPerCell);

Vec2 cells(GridPoint p, GridPoint origin) {
  return {(static_cast<double>(p.x) - origin.x) * kCell,
          (static_cast<double>(p.y) - origin.y) * kCell};
}

}  // namespace

void PrefixMoments::build(const Corridor& corridor, std::size_t start) {
  const std::size_t n = corridor.size();
  const GridPoint origin = corridor.points(start)[Corridor::kOwnPlace];
  sums_.resize(n + 1);
  sums_[0] = {};
  Vec2 a{0, 0};
  for (std::size_t k = 1, i = start; k <= n; ++k) {
    i = i + 1 < n ? i + 1 : 0;
    const Vec2 b = cells(corridor.points(i)[Corridor::kOwnPlace], origin);
    const Vec2 d = b - a;
    const double l = std::sqrt(d.x * d.x + d.y * d.y);
    const Sum& s = sums_[k - 1];
    sums_[k] = {s.w + l,
                s.x + l * (a.x + b.x) / 2,
                s.y + l * (a.y + b.y) / 2,
                s.xx + l * (a.x * a.x + a.x * d.x + d.x * d.x / 3),
                s.xy + l * (a.x * a.y + (a.x * d.y + d.x * a.y) / 2 + d.x * d.y / 3),
                s.yy + l * (a.y * a.y + a.y * d.y + d.y * d.y / 3)};
    a = b;
  }
}

double PrefixMoments::distortion(std::size_t from, std::size_t to, Ray<double> a,
                                 Ray<double> b) const {
  const Sum& s = sums_[from];
  const Sum& t = sums_[to];
  const Vec2 p{a.x * kCell, a.y * kCell}, q{b.x * kCell, b.y * kCell};
  const double nx = p.y - q.y, ny = q.x - p.x;
  const double c = nx * p.x + ny * p.y;
  const double m = nx * nx * (t.xx - s.xx) + 2 * nx * ny * (t.xy - s.xy) + ny * ny * (t.yy - s.yy);
  const double sum = m - 2 * c * (nx * (t.x - s.x) + ny * (t.y - s.y)) + c * c * (t.w - s.w);
  return std::max(0.0, sum / (nx * nx + ny * ny));
}

}  // namespace slipstick
