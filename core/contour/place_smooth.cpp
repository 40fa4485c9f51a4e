#include "core/contour/place_smooth.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/vec.h"

namespace slipstick {
namespace {

constexpr auto kCell = static_cast<double>(SliceGrid::kUnitsPerCell);

// A stick with its vertex at inside + t·(outside - inside), in cells.
struct Sliding {
  Vec2 inside;
  Vec2 outward;
  double t = 0.5;

  [[nodiscard]] Vec2 vertex() const { return inside + t * outward; }
};

std::vector<Sliding> cells_of(const ContourSet& contours, const ContourSet::Loop& loop) {
  std::vector<Sliding> result;
  result.reserve(loop.count);
  for (const Stick& stick : contours.sticks(loop)) {
    const Step e = step(stick.outward);
    result.push_back({{static_cast<double>(stick.column), static_cast<double>(stick.row)},
                      {static_cast<double>(e.x), static_cast<double>(e.y)}});
  }
  return result;
}

// Where the line between the neighbours meets the stick's line. The neighbours lie strictly on
// opposite sides of it, so there is no division by zero, and the result is in [0, 1].
double on_line(const Sliding& s, Vec2 before, Vec2 after) {
  const Vec2 a = before - s.inside, b = after - s.inside;
  const double across_a = cross(s.outward, a), across_b = cross(s.outward, b);
  return (dot(a, s.outward) * across_b - dot(b, s.outward) * across_a) / (across_b - across_a);
}

double on_projection(const Sliding& s, Vec2 before, Vec2 after) {
  return dot(0.5 * (before + after) - s.inside, s.outward);
}

using Target = double (*)(const Sliding&, Vec2 before, Vec2 after);

// In floating point t would reach the node after some 70 rounds; the place never does.
double kept_open(double t) {
  return std::clamp(t, 1 / kCell, 1 - 1 / kCell);
}

double round_of(std::vector<Sliding>& loop, std::vector<double>& next, Target target) {
  const std::size_t n = loop.size();
  double movement = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = loop[i == 0 ? n - 1 : i - 1].vertex();
    const Vec2 after = loop[i + 1 == n ? 0 : i + 1].vertex();
    next[i] = kept_open(loop[i].t + kSmoothingRate * (target(loop[i], before, after) - loop[i].t));
    movement += std::abs(next[i] - loop[i].t);
  }
  for (std::size_t i = 0; i < n; ++i) loop[i].t = next[i];
  return movement / static_cast<double>(n);
}

void smooth(ContourSet& contours, Target target) {
  for (const ContourSet::Loop& loop : contours.loops()) {
    std::vector<Sliding> cells = cells_of(contours, loop);
    std::vector<double> next(cells.size());
    for (int round = 0; round < kSmoothingRoundsMax; ++round) {
      if (round_of(cells, next, target) < kSmoothingMovementEnd) break;
    }
    const auto places = contours.places(loop);
    std::transform(cells.begin(), cells.end(), places.begin(),
                   [](const Sliding& s) { return Place::clamped(std::lround(s.t * kCell)); });
  }
}

}  // namespace

void place_sliding(ContourSet& contours) {
  smooth(contours, on_line);
}

void place_projection(ContourSet& contours) {
  smooth(contours, on_projection);
}

}  // namespace slipstick
