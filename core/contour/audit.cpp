#include "core/contour/audit.h"

#include <algorithm>
#include <cmath>

#include "core/contour/audit_edges.h"
#include "core/contour/audit_exact.h"

namespace slipstick {
namespace {

using namespace audit_exact;

using Violations = std::vector<Violation>;

void report(Violations& violations, Violation::Kind kind, Vec2 where) {
  if (violations.size() < kViolationsMax) violations.push_back({kind, where});
}

Violations bad_coordinates(const std::vector<AuditLoop>& loops) {
  Violations violations;
  for (const AuditLoop& loop : loops) {
    for (const Vec2 p : loop.points) {
      if (!representable(p)) report(violations, Violation::Kind::kCoordinate, p);
    }
    if (loop.points.empty()) report(violations, Violation::Kind::kDegenerate, {});
  }
  return violations;
}

Wide doubled_area(const std::vector<Point>& loop) {
  Wide sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += turn(loop[0], loop[i], loop[i + 1]);
  return sum;
}

void check_shape(const AuditLoop& loop, Violations& violations) {
  std::vector<Point> points;
  for (const Vec2 p : loop.points) points.push_back(point(p));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] == points[(i + 1) % points.size()]) {
      report(violations, Violation::Kind::kDegenerate, loop.points[i]);
    }
  }
  const int turned = sign(doubled_area(points));
  if (points.size() < 3 || turned == 0) {
    report(violations, Violation::Kind::kDegenerate, loop.points[0]);
  } else if ((turned > 0) != (loop.depth % 2 == 0) || loop.depth < 0) {
    report(violations, Violation::Kind::kOrientation, loop.points[0]);
  }
}

// `p` and `next` meet in a vertex; wrong is only if the second folds back onto the first.
bool folds(const Edge& edge, const Edge& next) {
  return turn(edge.from, edge.to, next.to) == 0 &&
         (between(edge.from, edge.to, next.to) || between(next.from, next.to, edge.from));
}

bool conflict(const Edge& a, const Edge& b) {
  if (a.loop == b.loop && b.from == a.to && b.index == a.next) return folds(a, b);
  if (a.loop == b.loop && a.from == b.to && a.index == b.next) return folds(b, a);
  return touch(a.from, a.to, b.from, b.to);
}

void check_crossings(const EdgeBuckets& edges, Violations& violations) {
  edges.for_each_close_pair([&](const Edge& a, const Edge& b) {
    if (conflict(a, b)) report(violations, Violation::Kind::kCrossing, mm(b.from));
  });
}

// Loops do not touch here, so any point of a loop tells how deep it lies: count the crossings of
// the ray to the left by other loops.
void check_nesting(const std::vector<AuditLoop>& loops, const EdgeBuckets& edges,
                   Violations& violations) {
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Point p = point(loops[i].points[0]);
    std::vector<std::size_t> crossed;
    edges.for_each_in_row_of(p.y, [&](const Edge& edge) {
      if (edge.loop != i && left_of(edge, p)) crossed.push_back(edge.loop);
    });
    std::sort(crossed.begin(), crossed.end());
    int around = 0;
    for (auto at = crossed.begin(); at != crossed.end();) {
      const auto next = std::upper_bound(at, crossed.end(), *at);
      around += static_cast<int>((next - at) % 2);
      at = next;
    }
    if (around != loops[i].depth) {
      report(violations, Violation::Kind::kNesting, loops[i].points[0]);
    }
  }
}

// A sample that an edge runs through is on neither side.
void check_row(const EdgeBuckets& edges, const BitImage& image, int row, Violations& violations) {
  const std::int64_t y = point({0, image.grid().node_y(row)}).y;
  std::vector<Crossing> crossings;
  std::vector<Edge> flat;
  edges.for_each_in_row_of(y, [&](const Edge& edge) {
    if (spans(edge, y)) crossings.push_back(crossing(edge, y));
    if (edge.from.y == y && edge.to.y == y) flat.push_back(edge);
  });
  std::sort(crossings.begin(), crossings.end());
  auto ahead = crossings.begin();
  for (int column = 0; column < image.columns(); ++column) {
    const Point node = point({image.grid().node_x(column), image.grid().node_y(row)});
    while (ahead != crossings.end() && ahead->x < node.x) ++ahead;
    const bool inside = (ahead - crossings.begin()) % 2 == 1;
    bool on_edge = std::any_of(flat.begin(), flat.end(),
                               [&](const Edge& e) { return between(e.from, e.to, node); });
    for (auto c = ahead; c != crossings.end() && c->x == node.x; ++c) on_edge |= c->exact;
    if (on_edge || inside != image.at(column, row)) {
      report(violations, Violation::Kind::kSample, mm(node));
    }
  }
}

bool on_open_stick(Point p, std::int64_t width) {
  return (p.x % width == 0) != (p.y % width == 0);
}

}  // namespace

std::string describe(Violation::Kind kind) {
  switch (kind) {
    case Violation::Kind::kCoordinate:
      return "coordinate out of range";
    case Violation::Kind::kDegenerate:
      return "degenerate loop or edge";
    case Violation::Kind::kCrossing:
      return "crossing or touching edges";
    case Violation::Kind::kOrientation:
      return "wrong orientation";
    case Violation::Kind::kNesting:
      return "wrong depth";
    case Violation::Kind::kOffStick:
      return "vertex off its stick";
    case Violation::Kind::kSample:
      return "sample on the wrong side";
  }
  return "unknown";
}

std::vector<Violation> audit_loops(const std::vector<AuditLoop>& loops) {
  Violations violations = bad_coordinates(loops);
  if (!violations.empty()) return violations;
  for (const AuditLoop& loop : loops) check_shape(loop, violations);
  const EdgeBuckets edges(loops);
  check_crossings(edges, violations);
  if (violations.empty()) check_nesting(loops, edges, violations);
  return violations;
}

std::vector<Violation> audit_sticks(const std::vector<AuditLoop>& loops, double width) {
  Violations violations = bad_coordinates(loops);
  if (!violations.empty()) return violations;
  const std::int64_t cell = std::llround(width * kUnitsPerMm);
  for (const AuditLoop& loop : loops) {
    for (const Vec2 p : loop.points) {
      if (cell <= 0 || !on_open_stick(point(p), cell)) {
        report(violations, Violation::Kind::kOffStick, p);
      }
    }
  }
  return violations;
}

std::vector<Violation> audit_samples(const std::vector<AuditLoop>& loops, const BitImage& image) {
  Violations violations = bad_coordinates(loops);
  if (!violations.empty()) return violations;
  const EdgeBuckets edges(loops);
  for (int row = 0; row < image.rows(); ++row) check_row(edges, image, row, violations);
  return violations;
}

}  // namespace slipstick
