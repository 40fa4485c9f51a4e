#include "core/contour/place_laplacian.h"

#include <cmath>
#include <cstddef>
#include <span>

#include "core/contour/place_smooth.h"

namespace slipstick {
namespace {

constexpr auto kCell = static_cast<double>(SliceGrid::kUnitsPerCell);

// \return how far the vertices moved on average.
double round_of(std::vector<Vec2>& loop, std::vector<Vec2>& next) {
  const std::size_t n = loop.size();
  double movement = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = loop[i == 0 ? n - 1 : i - 1], after = loop[i + 1 == n ? 0 : i + 1];
    next[i] = loop[i] + kSmoothingRate * (0.5 * (before + after) - loop[i]);
    movement += length(next[i] - loop[i]);
  }
  loop.swap(next);
  return movement / static_cast<double>(n);
}

Vec2 at(GridPoint p) {
  return {static_cast<double>(p.x) / kCell, static_cast<double>(p.y) / kCell};
}

Place nearest(const Stick& stick, Vec2 p) {
  const Step e = step(stick.outward);
  const Vec2 inside{static_cast<double>(stick.column), static_cast<double>(stick.row)};
  return Place::clamped(std::lround(
      dot(p - inside, Vec2{static_cast<double>(e.x), static_cast<double>(e.y)}) * kCell));
}

}  // namespace

std::vector<Vec2> free_laplacian(const ContourSet& contours, const ContourSet::Loop& loop) {
  const std::span<const Stick> sticks = contours.sticks(loop);
  const std::span<const Place> places = contours.places(loop);
  std::vector<Vec2> vertices, next(loop.count);
  vertices.reserve(loop.count);
  for (std::size_t i = 0; i < loop.count; ++i)
    vertices.push_back(at(position(sticks[i], places[i])));
  for (int round = 0; round < kSmoothingRoundsMax; ++round) {
    if (round_of(vertices, next) < kSmoothingMovementEnd) break;
  }
  return vertices;
}

void place_laplacian(ContourSet& contours) {
  for (const ContourSet::Loop& loop : contours.loops()) {
    const std::vector<Vec2> vertices = free_laplacian(contours, loop);
    const std::span<Place> places = contours.places(loop);
    for (std::size_t i = 0; i < loop.count; ++i) {
      places[i] = nearest(contours.sticks(loop)[i], vertices[i]);
    }
  }
}

}  // namespace slipstick
