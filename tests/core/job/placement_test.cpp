#include "core/job/placement.h"

#include <catch2/catch.hpp>

#include "tests/support/solids.h"

using namespace slipstick;

namespace {

bool near(Vec3 a, Vec3 b) {
  return length(a - b) < 1e-9;
}

}  // namespace

TEST_CASE("A model comes to lie on the bed, over its middle") {
  const auto placed = place_on_bed(test::BallModel(5), {}, {110, 100});

  REQUIRE(placed);
  CHECK(near(placed->bounds.low, {105, 95, 0}));
  CHECK(near(placed->bounds.high, {115, 105, 10}));
  CHECK(near(placed->to_model({110, 100, 5}), {0, 0, 0}));
}

TEST_CASE("Fit scales evenly to the tightest side") {
  PlacementRequest request;
  request.fit = Vec3{60, 40, 100};

  const auto placed = place_on_bed(test::BallModel(1), request, {0, 0});

  REQUIRE(placed);
  CHECK(near(placed->bounds.size(), {40, 40, 40}));
}

TEST_CASE("Inches are 25.4 mm") {
  PlacementRequest request;
  request.unit = 25.4;

  CHECK(place_on_bed(test::BallModel(1), request, {0, 0})->bounds.high.z == Approx(50.8));
}

TEST_CASE("Factors that are no positive numbers are refused") {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    PlacementRequest scale, fit;
    scale.scale = bad;
    fit.fit = Vec3{10, bad, 10};

    CHECK_FALSE(place_on_bed(test::BallModel(1), scale, {0, 0}));
    CHECK_FALSE(place_on_bed(test::BallModel(1), fit, {0, 0}));
  }
}

TEST_CASE("A solid beyond the build volume is refused with both sizes") {
  const auto placed = place_on_bed(test::BallModel(120), {}, {110, 110});

  const auto ok = check_build_volume(placed->bounds, PrinterSettings{});

  REQUIRE_FALSE(ok);
  CHECK_THAT(ok.error().message, Catch::Contains("240 x 240 x 240") && Catch::Contains("220") &&
                                     Catch::Contains("--fit"));
  PrinterSettings larger;
  larger.bed_size = {240, 240, 240};
  CHECK_FALSE(check_build_volume(placed->bounds, larger));
}

TEST_CASE("A round bed has its middle at 0 and is no larger than its circle") {
  PrinterSettings delta;
  delta.bed_shape = BedShape::kRound;
  delta.bed_size = {280, 280, 250};
  CHECK(bed_centre(delta) == Vec2{0, 0});
  const auto at = [&](double radius) {
    return place_on_bed(test::BallModel(radius), {}, bed_centre(delta))->bounds;
  };

  CHECK(check_build_volume(at(98), delta));
  // Its box has corners 99·√2 = 140.007 away.
  const auto beyond = check_build_volume(at(99), delta);
  REQUIRE_FALSE(beyond);
  CHECK_THAT(beyond.error().message, Catch::Contains("which is round"));
}
