#include "core/region/level.h"

#include <cmath>

#include "core/contour/simplify.h"
#include "core/contour/trace.h"

namespace slipstick {

void place_at_level(ContourSet& contours, const DistanceField& field, double level) {
  const auto sticks = contours.sticks();
  const auto places = contours.places();
  for (std::size_t i = 0; i < sticks.size(); ++i) {
    const Stick& s = sticks[i];
    const Step e = step(s.outward);
    const double inside = field.at(s.column, s.row);
    const double outside = field.at(s.column + e.x, s.row + e.y);
    if (outside >= level || inside <= outside) continue;
    const double t = (inside - level) / (inside - outside);
    places[i] = Place::clamped(std::llround(t * static_cast<double>(SliceGrid::kUnitsPerCell)));
  }
}

Outline level_outline(const BitImage& image, const DistanceField& field, double level,
                      double tolerance, Ambiguity ambiguity) {
  ContourSet contours = trace(image, ambiguity);
  place_at_level(contours, field, level);
  SimplifyOptions options;
  options.tolerance = tolerance;
  return simplify_greedy(contours, options).outline;
}

std::vector<std::vector<Vec2>> polygons_of(const Outline& outline) {
  std::vector<std::vector<Vec2>> polygons;
  for (const Outline::Loop& loop : outline.loops()) {
    polygons.emplace_back();
    for (const GridPoint p : loop.points) polygons.back().push_back(outline.mm(p));
  }
  return polygons;
}

}  // namespace slipstick
