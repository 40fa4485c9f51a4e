#include "core/toolpath/order.h"

#include <algorithm>
#include <limits>

#include "core/base/angle.h"

namespace slipstick {
namespace {

int rank(Role role) {
  switch (role) {
    case Role::kSkirt:
      return 0;
    case Role::kInnerPerimeter:
      return 1;
    case Role::kOuterPerimeter:
      return 2;
    case Role::kThinBead:
      return 3;
    case Role::kSkin:
      return 4;
    case Role::kInfill:
      return 5;
  }
  return 6;
}

void start_at_seam(Bead& bead, Vec2 towards) {
  if (!bead.closed) return;
  const auto seam = std::max_element(bead.points.begin(), bead.points.end(), [&](Vec2 a, Vec2 b) {
    return dot(a, towards) < dot(b, towards);
  });
  const auto shift = seam - bead.points.begin();
  if (bead.widths.size() > 1) {
    std::rotate(bead.widths.begin(), bead.widths.begin() + shift, bead.widths.end());
  }
  std::rotate(bead.points.begin(), seam, bead.points.end());
}

Vec2 end_of(const Bead& bead) {
  return bead.closed ? bead.points.front() : bead.points.back();
}

double squared(Vec2 a) {
  return dot(a, a);
}

// How far a bead's nearer end is; closed ones are only begun at their seam.
double way_to(const Bead& bead, Vec2 from) {
  const double front = squared(bead.points.front() - from);
  return bead.closed ? front : std::min(front, squared(bead.points.back() - from));
}

void turn_towards(Bead& bead, Vec2 from) {
  if (bead.closed || squared(bead.points.front() - from) <= squared(bead.points.back() - from)) {
    return;
  }
  std::reverse(bead.points.begin(), bead.points.end());
  std::reverse(bead.widths.begin(), bead.widths.end());
}

// Takes the nearest of beads[first, last) each time and moves it to the front. The rows of an
// infill are nearly in order already; only so many of the next are looked at.
void nearest_first(std::vector<Bead>& beads, std::size_t first, std::size_t last, Vec2& at) {
  constexpr std::size_t kLookAhead = 200;
  for (std::size_t i = first; i < last; ++i) {
    std::size_t best = i;
    for (std::size_t j = i + 1; j < std::min(last, i + kLookAhead); ++j) {
      if (way_to(beads[j], at) < way_to(beads[best], at)) best = j;
    }
    std::rotate(beads.begin() + static_cast<std::ptrdiff_t>(i),
                beads.begin() + static_cast<std::ptrdiff_t>(best),
                beads.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    turn_towards(beads[i], at);
    at = end_of(beads[i]);
  }
}

struct Island {
  std::vector<Vec2> border;
  double area = 0;
  std::vector<Bead> beads;
};

double area_of(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += cross(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]);
  }
  return sum / 2;
}

bool holds(const std::vector<Vec2>& polygon, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    inside ^= a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) < p.x;
  }
  return inside;
}

// The islands of a layer, the smallest first: the first that holds a point is the one it is on.
std::vector<Island> islands_of(const Outline& outline) {
  std::vector<Island> islands;
  for (const Outline::Loop& loop : outline.loops()) {
    if (loop.depth % 2 != 0) continue;
    Island island;
    for (const GridPoint p : loop.points) island.border.push_back(outline.mm(p));
    island.area = area_of(island.border);
    islands.push_back(std::move(island));
  }
  std::stable_sort(islands.begin(), islands.end(),
                   [](const Island& a, const Island& b) { return a.area < b.area; });
  return islands;
}

void order_island(std::vector<Bead>& beads, Vec2& at) {
  std::stable_sort(beads.begin(), beads.end(),
                   [](const Bead& a, const Bead& b) { return rank(a.role) < rank(b.role); });
  for (std::size_t first = 0; first < beads.size();) {
    std::size_t last = first;
    while (last < beads.size() && beads[last].role == beads[first].role) ++last;
    nearest_first(beads, first, last, at);
    first = last;
  }
}

double way_to(const Island& island, Vec2 from) {
  double best = std::numeric_limits<double>::infinity();
  for (const Vec2 p : island.border) best = std::min(best, squared(p - from));
  return best;
}

void append(std::vector<Bead>& to, std::vector<Bead>&& from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

std::vector<Bead> in_printing_order(std::vector<Bead> beads, const Outline& outline,
                                    double seam_degrees) {
  const Vec2 towards = direction_of(seam_degrees);
  std::vector<Island> islands = islands_of(outline);
  std::vector<Bead> ordered;  // what is on no island, the skirt, comes first
  for (Bead& bead : beads) {
    start_at_seam(bead, towards);
    const auto home = bead.role == Role::kSkirt
                          ? islands.end()
                          : std::find_if(islands.begin(), islands.end(), [&](const Island& i) {
                              return holds(i.border, bead.points.front());
                            });
    (home == islands.end() ? ordered : home->beads).push_back(std::move(bead));
  }
  Vec2 at = ordered.empty() ? Vec2{} : end_of(ordered.back());
  while (!islands.empty()) {
    const auto next = std::min_element(
        islands.begin(), islands.end(),
        [&](const Island& a, const Island& b) { return way_to(a, at) < way_to(b, at); });
    order_island(next->beads, at);
    append(ordered, std::move(next->beads));
    islands.erase(next);
  }
  return ordered;
}

}  // namespace slipstick
