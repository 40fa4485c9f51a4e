#include "core/contour/corridor.h"

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

// One of the two edges at a vertex: how far it goes across the vertex's stick, and its length,
// squared.
struct Slanted {
  double across;
  double square;
};

Slanted slanted(GridPoint a, GridPoint b, Outward outward) {
  const double x = static_cast<double>(b.x) - a.x;
  const double y = static_cast<double>(b.y) - a.y;
  return {std::abs(step(outward).x != 0 ? y : x), x * x + y * y};
}

// 1 / |normal · stick| for the steeper of two edges.
double least_slant(Slanted a, Slanted b) {
  const bool first = a.across * a.across * b.square >= b.across * b.across * a.square;
  const auto [across, square] = first ? a : b;
  const double length = std::sqrt(square);
  return across * Corridor::kSlantMax <= length ? Corridor::kSlantMax : length / across;
}

}  // namespace

void Corridor::build(const LoopView& loop, double tolerance) {
  tolerance_ = tolerance;
  const std::size_t n = loop.size();
  sticks_.resize(n);
  places_.resize(n);
  points_.resize(n);
  GridPoint before = loop.vertex(n - 1), own = loop.vertex(0);
  for (std::size_t i = 0; i < n; ++i) {
    const GridPoint after = loop.vertex(i + 1);
    sticks_[i] = loop.stick(i);
    places_[i][kOwnPlace] = loop.place(i);
    points_[i][kOwnPlace] = own;
    // At a corner the steeper of the two edges counts.
    const Outward outward = sticks_[i].outward;
    set(i, tolerance * least_slant(slanted(before, own, outward), slanted(own, after, outward)));
    before = own;
    own = after;
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
