// Fewest edges: never farther off than the tolerance, never more edges than the paper's
// segmentation or the greedy form, never fewer than the bound.
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/contour/audit.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "tests/support/images.h"
#include "tests/support/lower_bound.h"
#include "tests/support/outlines.h"

using namespace slipstick;

namespace {

void place_anyhow(ContourSet& contours, Rng& rng, std::uint64_t range) {
  for (Place& place : contours.places()) {
    place = Place::clamped(static_cast<std::int64_t>(32768 - range / 2 + rng.below(range)));
  }
}

BitImage image(Rng& rng) {
  if (rng.below(2) == 0) return test::structured(rng);
  return test::noise(rng, 1 + static_cast<int>(rng.below(20)), 1 + static_cast<int>(rng.below(20)),
                     0.1 + 0.8 * rng.unit());
}

struct Case {
  ContourSet contours;
  SimplifyOptions options;
};

Case drawn(std::uint64_t seed) {
  Rng rng(seed);
  Case c{trace(image(rng), rng.below(2) == 0 ? Ambiguity::kSolid : Ambiguity::kVoid), {}};
  place_anyhow(c.contours, rng, 1 + rng.below(65535));
  c.options.tolerance = rng.unit() * 0.1;
  c.options.alpha = static_cast<int>(1 + rng.below(15));
  return c;
}

// Whether `p` lies on the open stick, and if so, where.
std::optional<Place> on(Stick stick, GridPoint p) {
  const Step e = step(stick.outward);
  const GridPoint node = inside_node(stick);
  const std::int64_t k = std::int64_t{e.x} * (p.x - node.x) + std::int64_t{e.y} * (p.y - node.y);
  const auto place = Place::clamped(k);
  return position(stick, place) == p ? std::optional(place) : std::nullopt;
}

// Where the segment from a to b crosses the stick, to the nearest place.
Place crossing(Stick stick, GridPoint a, GridPoint b) {
  const GridPoint node = inside_node(stick);
  const Step e = step(stick.outward);
  const double along_a = e.x * (a.x - node.x) + e.y * (a.y - node.y);
  const double along_b = e.x * (b.x - node.x) + e.y * (b.y - node.y);
  const double across_a = e.x * (a.y - node.y) - e.y * (a.x - node.x);
  const double across_b = e.x * (b.y - node.y) - e.y * (b.x - node.x);
  const double share = across_a / (across_a - across_b);
  return Place::clamped(std::lround(along_a + share * (along_b - along_a)));
}

// Puts every vertex of `contours` onto `outline`, which was made of them.
void put_onto(ContourSet& contours, const Outline& outline) {
  for (std::size_t loop = 0; loop < contours.loops().size(); ++loop) {
    const auto& points = outline.loops()[loop].points;
    const auto sticks = std::as_const(contours).sticks(contours.loops()[loop]);
    const auto places = contours.places(contours.loops()[loop]);
    std::size_t next = 0;
    for (std::size_t i = 0; i < sticks.size(); ++i) {
      const GridPoint to = points[next % points.size()];
      if (const auto place = on(sticks[i], to)) {
        places[i] = *place;
        ++next;
      } else {
        places[i] = crossing(sticks[i], points[(next + points.size() - 1) % points.size()], to);
      }
    }
    REQUIRE(next == points.size());
  }
}

std::size_t fewest_edges(const Case& c) {
  return simplify_fewest(c.contours, c.options).outline.edges();
}

}  // namespace

TEST_CASE("Fewest edges stay within the tolerance") {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    INFO("seed " << seed);
    const Case c = drawn(seed);

    const Simplified fewest = simplify_fewest(c.contours, c.options);

    // A window is never shorter than one unit to each side of the contour's own place.
    REQUIRE(fewest.max_deviation <= c.options.tolerance + c.contours.grid().unit());
  }
}

TEST_CASE("Fewest edges are no more than those of the paper's segmentation or the greedy form") {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    INFO("seed " << seed);
    const Case c = drawn(seed);

    const std::size_t edges = fewest_edges(c);

    REQUIRE(edges <= simplify_vsa(c.contours, c.options).outline.edges());
    REQUIRE(edges <= simplify_greedy(c.contours, c.options).outline.edges());
  }
}

TEST_CASE("No choice of edges through the windows has fewer than the bound") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const Case c = drawn(seed);

    REQUIRE(fewest_edges(c) >= test::fewest_edges_bound(c.contours, c.options.tolerance));
  }
}

TEST_CASE("A straight side is one edge, so a square of samples has at most eight") {
  const ContourSet contours =
      trace(test::image_of({"#####", "#####", "#####", "#####", "#####"}), Ambiguity::kSolid);

  const Simplified fewest = simplify_fewest(contours, {0.01, 10});

  CHECK(fewest.outline.edges() <= 8);
  CHECK(fewest.outline.edges() >= 4);
}

// Longer than doubles are exact for, and longer than any one edge is looked for.
TEST_CASE("Sides of thousands of sticks are one edge, of more than 8192 two") {
  for (const int length : {990, 1010, 3000, 8000, 9000, 16000}) {
    INFO("length " << length);
    const BitImage bar = test::image_of({std::string(static_cast<std::size_t>(length), '#')});
    const ContourSet contours = trace(bar, Ambiguity::kSolid);

    const Simplified fewest = simplify_fewest(contours, {0.01, 10});

    const auto loops = test::audit_loops_of(fewest.outline);
    CHECK(audit_loops(loops).empty());
    CHECK(audit_samples(loops, bar).empty());
    CHECK(fewest.outline.edges() <= (length < 8192 ? 6U : 8U));
  }
}

TEST_CASE("The distortion of fewest edges is that of the worst edge alone") {
  // Two sides of a bar bend by a thirty-second of a cell, the middle one towards the solid.
  const BitImage bar = test::image_of({std::string(64, '#')});
  ContourSet contours = trace(bar, Ambiguity::kSolid);
  for (std::size_t i = 0; i < contours.places().size(); ++i) {
    const Stick s = contours.sticks()[i];
    if (s.outward != Outward::kNorth) continue;
    const double across = (s.column - 33.5) / 31.5;
    contours.places()[i] = Place::clamped(32768 + std::lround(2048 * across * across));
  }

  const Simplified fewest = simplify_fewest(contours, {0.1 * 0.125, 10});

  // An edge deviates by at most d, so its D' is at most d^2 times the length of its run.
  const double most = fewest.max_deviation * fewest.max_deviation * 66 * 0.125;
  CHECK(fewest.max_deviation > 0.001 * 0.125);
  CHECK(fewest.max_regional_distortion > most / 100);
  CHECK(fewest.max_regional_distortion <= most);
}

TEST_CASE("The same contours give the same outline, whatever was simplified before") {
  const Case c = drawn(7);
  const Simplified first = simplify_fewest(c.contours, c.options);
  static_cast<void>(fewest_edges(drawn(8)));

  const Simplified again = simplify_fewest(c.contours, c.options);

  REQUIRE(first.outline.loops().size() == again.outline.loops().size());
  for (std::size_t i = 0; i < first.outline.loops().size(); ++i) {
    CHECK(first.outline.loops()[i].points == again.outline.loops()[i].points);
  }
}

// The contour has moved by up to the tolerance and may move by as much again, so fewer are allowed;
// each loop begins where the greedy chain settles, which may cost it one.
TEST_CASE("An outline simplified again has no more edges") {
  std::size_t before = 0, after = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    INFO("seed " << seed);
    Case c = drawn(seed);
    const Simplified first = simplify_fewest(c.contours, c.options);

    put_onto(c.contours, first.outline);
    const std::size_t again = fewest_edges(c);

    REQUIRE(again <= first.outline.edges() + c.contours.loops().size());
    before += first.outline.edges();
    after += again;
  }
  CHECK(after <= before);
}

TEST_CASE("With one candidate every vertex is one of the contour's own") {
  std::size_t three = 0, one = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    INFO("seed " << seed);
    Case c = drawn(seed);
    three += fewest_edges(c);
    c.options.candidates = Candidates::kOne;

    const Simplified simplified = simplify_fewest(c.contours, c.options);

    one += simplified.outline.edges();
    REQUIRE(simplified.max_deviation <= c.options.tolerance + c.contours.grid().unit());
    std::set<std::pair<int, int>> own;
    for (std::size_t i = 0; i < c.contours.sticks().size(); ++i) {
      const GridPoint p = position(c.contours.sticks()[i], c.contours.places()[i]);
      own.insert({p.x, p.y});
    }
    for (const Outline::Loop& loop : simplified.outline.loops()) {
      for (const GridPoint p : loop.points) REQUIRE(own.count({p.x, p.y}) == 1);
    }
  }
  CHECK(three < one);
}

TEST_CASE("A larger tolerance hardly ever gives more edges") {
  std::size_t before = 0, after = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    INFO("seed " << seed);
    Case c = drawn(seed);
    const std::size_t edges = fewest_edges(c);
    c.options.tolerance *= 1.5;
    const std::size_t fewer = fewest_edges(c);
    before += edges;
    after += fewer;

    // The search looks from few sticks, and narrowed windows differ: one edge in fifty and one.
    REQUIRE(fewer <= edges + edges / 50 + 1);
  }
  CHECK(after < before);
}
