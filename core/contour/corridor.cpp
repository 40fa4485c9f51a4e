#include "core/contour/corridor.h"

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

// 1 / |normal · stick| for the edge between two vertices.
double slant(GridPoint before, GridPoint after, Outward outward) {
  const double x = static_cast<double>(after.x) - before.x;
  const double y = static_cast<double>(after.y) - before.y;
  const double across = std::abs(step(outward).x != 0 ? y : x);
  const double length = std::sqrt(x * x + y * y);
  return across * Corridor::kSlantMax <= length ? Corridor::kSlantMax : length / across;
}

}  // namespace

void Corridor::build(const LoopView& loop, double tolerance) {
  tolerance_ = tolerance;
  const std::size_t n = loop.size();
  sticks_.resize(n);
  places_.resize(n);
  points_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    sticks_[i] = loop.stick(i);
    places_[i][kOwnPlace] = loop.place(i);
    points_[i][kOwnPlace] = loop.vertex(i);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const GridPoint before = points_[i > 0 ? i - 1 : n - 1][kOwnPlace];
    const GridPoint after = points_[i + 1 < n ? i + 1 : 0][kOwnPlace];
    const GridPoint own = points_[i][kOwnPlace];
    // At a corner the steeper of the two edges counts.
    set(i, tolerance * std::min(slant(before, own, sticks_[i].outward),
                                slant(own, after, sticks_[i].outward)));
  }
}

void Corridor::tighten(std::size_t i) {
  set(i, tolerance_);
}

void Corridor::set(std::size_t i, double reach) {
  constexpr auto kCell = static_cast<double>(SliceGrid::kUnitsPerCell);
  const auto e = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(reach, kCell)));
  const std::int64_t own = places_[i][kOwnPlace].value();
  places_[i].front() = Place::clamped(own - e);
  places_[i].back() = Place::clamped(own + e);
  points_[i].front() = position(sticks_[i], places_[i].front());
  points_[i].back() = position(sticks_[i], places_[i].back());
}

}  // namespace slipstick
