#include "sim/deposit.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/toolpath/flow.h"

using namespace slipstick;

namespace {

constexpr double kFilament = 1.75;

struct Bench {
  std::vector<ExtrudedSegment> beads;
  Deposit deposit{kFilament, [this](const ExtrudedSegment& bead) { beads.push_back(bead); }};

  /// 10 mm along X at `z` with `e` mm of filament.
  void lay(double z, double e) { deposit.add({{0, 0, z, 0}, {10, 0, z, e}, 50, 0, 1}); }
};

}  // namespace

TEST_CASE("A bead is as wide as its filament makes it") {
  Bench bench;

  bench.lay(0.2, filament_length(bead_area(0.45, 0.2), 10, kFilament));

  REQUIRE(bench.beads.size() == 1);
  CHECK(bench.beads[0].width == Approx(0.45));
  CHECK(bench.beads[0].height == Approx(0.2));
  CHECK(bench.beads[0].b == Vec2{10, 0});
}

TEST_CASE("A layer is as high as it is above the layer below") {
  Bench bench;
  for (const double z : {0.3, 0.3, 0.5, 0.6}) bench.lay(z, 0.5);

  CHECK(bench.beads[1].height == Approx(0.3));
  CHECK(bench.beads[2].height == Approx(0.2));
  CHECK(bench.beads[3].height == Approx(0.1));
}

TEST_CASE("A prime line higher than the first layer is not what the second one lies on") {
  Bench bench;
  for (const double z : {0.3, 0.2, 0.4}) bench.lay(z, 0.5);

  CHECK(bench.beads[1].height == Approx(0.2));
  CHECK(bench.beads[2].height == Approx(0.2));
}

TEST_CASE("Travels, retractions and priming on the spot leave no bead") {
  Bench bench;
  bench.lay(0.2, 0);
  bench.lay(0.2, -1);
  bench.deposit.add({{5, 5, 0.2, 0}, {5, 5, 0.2, 1}, 50, 0, 1});

  CHECK(bench.beads.empty());
}
