#include "sim/judge.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/pixel_image.h"
#include "sim/print_judge.h"

using namespace slipstick;

namespace {

using Loop = std::vector<Vec2>;
using Beads = std::vector<ExtrudedSegment>;

constexpr double kWidth = 0.45;

Loop circle(Vec2 centre, double radius) {
  Loop loop;
  for (int i = 0; i < 180; ++i) {
    const double t = 2 * std::numbers::pi * i / 180;
    loop.push_back({centre.x + radius * std::cos(t), centre.y + radius * std::sin(t)});
  }
  return loop;
}

/// Solid lies outside it: clockwise.
Loop hole(Vec2 centre, double radius) {
  Loop loop = circle(centre, radius);
  std::reverse(loop.begin(), loop.end());
  return loop;
}

Loop square(Vec2 low, double side) {
  return {low, {low.x + side, low.y}, {low.x + side, low.y + side}, {low.x, low.y + side}};
}

void add(Beads& beads, Vec2 a, Vec2 b) {
  beads.push_back({a, b, kWidth, 0.2, 0.2});
}

/// A closed bead around `loop`, or all of it but the last `open` edges.
void trace(Beads& beads, const Loop& loop, std::size_t open = 0) {
  for (std::size_t i = 0; i + open < loop.size(); ++i)
    add(beads, loop[i], loop[(i + 1) % loop.size()]);
}

/// Rings side by side that fill what is between two radii.
Beads ring_fill(Vec2 centre, double inner, double outer) {
  Beads beads;
  for (double r = outer - kWidth / 2; r > inner + kWidth / 2; r -= 0.4)
    trace(beads, circle(centre, r));
  trace(beads, circle(centre, inner + kWidth / 2));
  return beads;
}

}  // namespace

TEST_CASE("A disc filled with rings is right") {
  const LayerVerdict v = judge_layer(ring_fill({0, 0}, 0, 5), {circle({0, 0}, 5)});

  CHECK(v.components == 1);
  CHECK(v.holes == 0);
  CHECK(v.components_wrong == 0);
  CHECK(v.holes_wrong == 0);
  CHECK(v.solid_mm2 == Approx(25 * std::numbers::pi).epsilon(0.01));
  CHECK(v.area_error < 0.01);
}

TEST_CASE("An annulus has one hole and it is open") {
  const LayerVerdict v = judge_layer(ring_fill({0, 0}, 2, 5), {circle({0, 0}, 5), hole({0, 0}, 2)});

  CHECK(v.holes == 1);
  CHECK(v.components_wrong == 0);
  CHECK(v.holes_wrong == 0);
}

TEST_CASE("A bead across a hole cuts it in two") {
  Beads beads = ring_fill({0, 0}, 2, 5);
  add(beads, {-2.2, 0}, {2.2, 0});

  const LayerVerdict v = judge_layer(beads, {circle({0, 0}, 5), hole({0, 0}, 2)});

  CHECK(v.components_wrong == 0);
  CHECK(v.holes_wrong == 1);
}

TEST_CASE("A hole that was filled up is wrong") {
  const LayerVerdict v = judge_layer(ring_fill({0, 0}, 0, 5), {circle({0, 0}, 5), hole({0, 0}, 2)});

  CHECK(v.holes_wrong == 1);
  CHECK(v.area_error > 0.1);
}

TEST_CASE("A broken ring joins its hole with the outside") {
  Beads beads;
  trace(beads, circle({0, 0}, 3), 20);

  const LayerVerdict v =
      judge_layer(beads, {circle({0, 0}, 3 + kWidth / 2), hole({0, 0}, 3 - kWidth / 2)});

  CHECK(v.components_wrong == 0);
  CHECK(v.holes_wrong == 1);
}

TEST_CASE("The cells of sparse infill are voids, not holes") {
  Beads beads;
  trace(beads, square({kWidth / 2, kWidth / 2}, 20 - kWidth));
  for (double x = 3; x < 19; x += 3) add(beads, {x, 0.3}, {x, 19.7});
  for (double y = 3; y < 19; y += 3) add(beads, {0.3, y}, {19.7, y});

  const LayerVerdict v = judge_layer(beads, {square({0, 0}, 20)});

  CHECK(v.components_wrong == 0);
  CHECK(v.holes_wrong == 0);
  CHECK(v.void_mm2 > 200);
  CHECK(v.area_error == Approx(0).margin(0.005));
}

TEST_CASE("A string of ooze joins two islands") {
  Beads beads = ring_fill({0, 0}, 0, 2);
  for (const ExtrudedSegment& bead : ring_fill({10, 0}, 0, 2)) beads.push_back(bead);
  const Contours contours{circle({0, 0}, 2), circle({10, 0}, 2)};
  CHECK(judge_layer(beads, contours).components_wrong == 0);

  add(beads, {0, 0}, {10, 0});

  CHECK(judge_layer(beads, contours).components_wrong == 1);
}

TEST_CASE("A missing island is wrong") {
  const LayerVerdict v =
      judge_layer(ring_fill({0, 0}, 0, 2), {circle({0, 0}, 2), circle({10, 0}, 2)});

  CHECK(v.components_wrong == 1);
}

TEST_CASE("An island in two pieces is cut") {
  Beads beads;
  add(beads, {0.3, 1}, {4, 1});
  add(beads, {6, 1}, {9.7, 1});

  const LayerVerdict v = judge_layer(beads, {{{0, 0.5}, {10, 0.5}, {10, 1.5}, {0, 1.5}}});

  CHECK(v.components_wrong == 1);
}

TEST_CASE("A skirt is stray: it encloses the part and yet joins or cuts nothing") {
  Beads beads = ring_fill({0, 0}, 2, 5);
  trace(beads, circle({0, 0}, 9));

  const LayerVerdict v = judge_layer(beads, {circle({0, 0}, 5), hole({0, 0}, 2)});

  CHECK(v.components_wrong == 0);
  CHECK(v.holes_wrong == 0);
  CHECK(v.area_error < 0.01);
  CHECK(v.stray_mm2 == Approx(2 * std::numbers::pi * 9 * kWidth).epsilon(0.02));
}

TEST_CASE("Nothing printed where nothing should be is right") {
  const LayerVerdict v = judge_layer({}, {});

  CHECK(v.components_wrong == 0);
  CHECK(v.holes_wrong == 0);
}

TEST_CASE("A hole of three pixels that was closed up is wrong, a smaller one is beyond telling") {
  const auto closed = [](double radius) {
    return judge_layer(ring_fill({0, 0}, 0, 5), {circle({0, 0}, 5), hole({0, 0}, radius)});
  };

  CHECK(closed(0.12).holes_wrong == 1);
  CHECK(closed(0.04).holes_wrong == 0);
  CHECK(closed(0.04).holes == 1);
}

TEST_CASE("An island in a hole is a component of its own") {
  Beads beads = ring_fill({0, 0}, 3, 5);
  for (const ExtrudedSegment& bead : ring_fill({0, 0}, 0, 1.5)) beads.push_back(bead);

  const LayerVerdict v =
      judge_layer(beads, {circle({0, 0}, 5), hole({0, 0}, 3), circle({0, 0}, 1.5)});

  CHECK(v.components == 2);
  CHECK(v.components_wrong == 0);
  CHECK(v.holes_wrong == 0);
}

TEST_CASE("A capsule covers what is within half its width of the segment, whichever way it lies") {
  const PixelFrame frame = PixelFrame::over({{-3, -3}, {3, 3}}, 0.1);
  for (const Vec2 b : {Vec2{1, 0}, Vec2{0, 1}, Vec2{1.2, 0.7}, Vec2{-0.8, 1.9}, Vec2{0, 0}}) {
    PixelImage image(frame);
    const Vec2 a{-0.3, -0.45};
    image.draw_capsule(a, b, 0.7);

    std::int64_t expected = 0;
    for (int r = 0; r < frame.rows; ++r) {
      for (int c = 0; c < frame.columns; ++c) {
        const Vec2 p{frame.low.x + (c + 0.5) * frame.size, frame.centre_y(r)};
        const Vec2 d = b - a;
        const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
        if (length(p - (a + t * d)) <= 0.35) ++expected;
      }
    }
    CHECK(image.count() == expected);
  }
}

TEST_CASE("A print is judged layer by layer, by the contours of each height") {
  std::vector<double> asked;
  PrintJudge judge([&](double z, double) -> std::optional<Contours> {
    asked.push_back(z);
    if (z > 0.5) return std::nullopt;
    return Contours{circle({0, 0}, 2)};
  });
  for (const double z : {0.2, 0.4, 0.6}) {
    Beads beads = ring_fill({0, 0}, 0, z == 0.4 ? 1 : 2);
    if (z == 0.4) add(beads, {1, 0}, {4, 0});
    for (ExtrudedSegment& bead : beads) {
      bead.z = z;
      judge.add(bead);
    }
  }

  const PrintVerdict& v = judge.finish();

  CHECK(asked == std::vector<double>{0.2, 0.4, 0.6});
  CHECK(v.layers == 2);
  CHECK(v.layers_unknown == 1);
  CHECK(v.components_wrong == 0);
  CHECK(v.area_error_max > 0.05);
  CHECK(v.area_error_mean == Approx(v.area_error_max / 2).margin(0.01));
}
