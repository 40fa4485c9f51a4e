// The deviation of a run from its edge, against each vertex looked at by itself.
#include "core/contour/chord.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/vec.h"
#include "core/contour/trace.h"
#include "tests/support/images.h"

using namespace slipstick;

namespace {

Vec2 exact(GridPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

// Feet of the perpendiculars, which never go back; whether any had to be held.
struct Slow {
  double deviation = 0;
  bool turns = false;
};

Slow slowly(const LoopView& loop, Run run) {
  const Vec2 a = exact(loop.vertex(run.first)), edge = exact(loop.vertex(run.last)) - a;
  Slow result;
  double at = 0;
  for (std::size_t i = run.first + 1; i < run.last; ++i) {
    const Vec2 v = exact(loop.vertex(i)) - a;
    const double foot = dot(edge, edge) > 0 ? dot(v, edge) / dot(edge, edge) : 0;
    result.turns |= foot < at || foot > 1;
    at = std::clamp(foot, at, 1.0);
    result.deviation = std::max(result.deviation, length(v - at * edge));
  }
  return result;
}

}  // namespace

TEST_CASE("The deviation of a run is that of its farthest vertex, whether or not it turns back") {
  int straight = 0, turning = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    ContourSet contours = trace(test::structured(rng), Ambiguity::kSolid);
    for (Place& place : contours.places()) {
      place = Place::clamped(static_cast<std::int64_t>(rng.below(65536)));
    }
    for (const ContourSet::Loop& contour : contours.loops()) {
      const LoopView loop(contours, contour);
      const std::size_t first = rng.below(loop.size());
      // Once round, too: then the edge is a point.
      const std::size_t most =
          rng.below(4) == 0 ? loop.size() : std::min<std::size_t>(8, loop.size());
      const Run run{first, first + 1 + rng.below(most)};
      const Slow slow = slowly(loop, run);
      (slow.turns ? turning : straight) += 1;
      REQUIRE(deviation(loop, run) == Approx(slow.deviation).epsilon(1e-9).margin(1e-9));
    }
  }
  CHECK(straight > 50);
  CHECK(turning > 50);
}
