// The audit must be worth trusting: every kind of fault, planted, is caught.
#include "core/contour/audit.h"

#include <catch2/catch.hpp>
#include <limits>

#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "tests/support/images.h"
#include "tests/support/outlines.h"

using namespace slipstick;
using Kind = Violation::Kind;

namespace {

std::vector<AuditLoop> square(double low, double high, int depth) {
  std::vector<Vec2> points{{low, low}, {high, low}, {high, high}, {low, high}};
  if (depth % 2 == 1) std::swap(points[1], points[3]);
  return {{points, depth}};
}

std::vector<AuditLoop> operator+(std::vector<AuditLoop> a, const std::vector<AuditLoop>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

bool finds(const std::vector<Violation>& violations, Kind kind) {
  for (const Violation& v : violations) {
    if (v.kind == kind) return true;
  }
  return false;
}

struct Sliced {
  BitImage image;
  std::vector<AuditLoop> loops;
};

Sliced sliced(std::uint64_t seed) {
  Rng rng(seed);
  BitImage image = test::noise(rng, 24, 24, 0.6);
  const auto contours = trace(image, Ambiguity::kSolid);
  auto loops = test::audit_loops_of(simplify_vsa(contours, {}).outline);
  return {std::move(image), std::move(loops)};
}

bool sound(const Sliced& s) {
  return audit_loops(s.loops).empty() && audit_sticks(s.loops, s.image.grid().width()).empty() &&
         audit_samples(s.loops, s.image).empty();
}

}  // namespace

TEST_CASE("Nested squares of the right depth and direction are sound") {
  CHECK(audit_loops(square(0, 9, 0) + square(1, 8, 1) + square(2, 3, 2) + square(4, 5, 2)).empty());
}

TEST_CASE("A loop that runs the wrong way is found") {
  auto loops = square(0, 1, 0);
  std::swap(loops[0].points[1], loops[0].points[3]);

  CHECK(finds(audit_loops(loops), Kind::kOrientation));
}

TEST_CASE("A wrong depth is found") {
  CHECK(finds(audit_loops(square(0, 9, 0) + square(1, 8, 3)), Kind::kNesting));
  CHECK(finds(audit_loops(square(0, 1, 0) + square(2, 3, 1)), Kind::kNesting));
}

TEST_CASE("Loops that cross, touch in a point or share an edge are found") {
  CHECK(finds(audit_loops(square(0, 2, 0) + square(1, 3, 0)), Kind::kCrossing));
  CHECK(finds(audit_loops(square(0, 1, 0) + square(1, 2, 0)), Kind::kCrossing));
  CHECK(finds(audit_loops(square(0, 3, 0) + square(0, 2, 1)), Kind::kCrossing));
}

TEST_CASE("A bow tie and a spike are found") {
  CHECK(finds(audit_loops({{{{0, 0}, {2, 2}, {2, 0}, {0, 1}}, 0}}), Kind::kCrossing));
  CHECK(finds(audit_loops({{{{0, 0}, {4, 0}, {2, 0}, {2, 3}}, 0}}), Kind::kCrossing));
}

TEST_CASE("Degenerate loops and bad numbers are found") {
  CHECK(finds(audit_loops({{{}, 0}}), Kind::kDegenerate));
  CHECK(finds(audit_loops({{{{0, 0}, {1, 0}}, 0}}), Kind::kDegenerate));
  CHECK(finds(audit_loops({{{{0, 0}, {0, 0}, {1, 0}, {1, 1}}, 0}}), Kind::kDegenerate));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(finds(audit_loops({{{{0, 0}, {nan, 0}, {1, 1}}, 0}}), Kind::kCoordinate));
  CHECK(finds(audit_loops({{{{0, 0}, {1e9, 0}, {1, 1}}, 0}}), Kind::kCoordinate));
}

TEST_CASE("A gap of one unit is no touch, none is") {
  const double unit = 0x1p-40;

  CHECK(audit_loops(square(0, 1, 0) + square(1 + unit, 2, 0)).empty());
  CHECK(finds(audit_loops(square(0, 1, 0) + square(1, 2, 0)), Kind::kCrossing));
}

TEST_CASE("A vertex on a node or off the lattice lines is off its stick") {
  CHECK(audit_sticks({{{{0.5, 1}, {1, 0.5}, {0.5, 0}}, 0}}, 1).empty());
  CHECK(finds(audit_sticks({{{{1, 1}, {1, 0.5}, {0.5, 0}}, 0}}, 1), Kind::kOffStick));
  CHECK(finds(audit_sticks({{{{0.5, 0.5}, {1, 0.5}, {0.5, 0}}, 0}}, 1), Kind::kOffStick));
}

TEST_CASE("A flipped sample is found wherever it is") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Sliced s = sliced(seed);
    REQUIRE(sound(s));
    Rng rng(seed + 1000);
    const int column = 2 + static_cast<int>(rng.below(24)),
              row = 2 + static_cast<int>(rng.below(24));

    s.image.set(column, row, !s.image.at(column, row));

    CHECK(finds(audit_samples(s.loops, s.image), Kind::kSample));
  }
}

TEST_CASE("A lost or doubled loop is found") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Sliced whole = sliced(seed);
    Rng rng(seed);
    const auto which = static_cast<std::ptrdiff_t>(rng.below(whole.loops.size()));
    Sliced lost = whole, doubled = whole;

    lost.loops.erase(lost.loops.begin() + which);
    doubled.loops.push_back(whole.loops[static_cast<std::size_t>(which)]);

    CHECK(finds(audit_samples(lost.loops, lost.image), Kind::kSample));
    CHECK(finds(audit_loops(doubled.loops), Kind::kCrossing));
  }
}

TEST_CASE("A vertex moved by more than its stick is found") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Sliced s = sliced(seed);
    Rng rng(seed);
    auto& loop = s.loops[rng.below(s.loops.size())];
    Vec2& vertex = loop.points[rng.below(loop.points.size())];

    vertex = vertex + 0.125 * Vec2{rng.unit() - 0.5, rng.unit() + 1};

    CHECK_FALSE(sound(s));
  }
}

TEST_CASE("A sample that an edge runs through is on no side") {
  const BitImage image = test::image_of({"##", "##"});
  const double low = image.grid().node_x(2), high = image.grid().node_x(3);
  const double margin = 0.0625;

  CHECK(audit_samples(square(low - margin, high + margin, 0), image).empty());
  CHECK(finds(audit_samples(square(low, high + margin, 0), image), Kind::kSample));
}
