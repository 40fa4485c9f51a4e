// Fewest edges: never farther off than the tolerance, never more edges than the paper's
// segmentation or the greedy form, never fewer than the bound.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

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
