// How thin solids and gaps are, by shapes of which it is known.
#include "core/region/feature_size.h"

#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "core/formats/lua_script.h"
#include "core/job/placement.h"

using namespace slipstick;

namespace {

// Normals are within about 2^-10 / 2^-3 / 2 of their slopes, so what is seen at 45 degrees or more
// within a hundredth of its thickness.
constexpr double kShare = 0.01;
// Enough for these, and quick.
constexpr FeatureSampling kCoarse{15, 250};

FeatureSizes sizes_of(const std::string& script) {
  const auto model = load_lua_model("return " + script, "test.lua");
  INFO((model ? std::string() : model.error().message));
  REQUIRE(model);
  const auto placed = place_on_bed(**model, {}, {0, 0});
  REQUIRE(placed);
  const auto sizes = feature_sizes(**model, inverse(placed->to_model), placed->bounds, kCoarse);
  REQUIRE(sizes);
  return *sizes;
}

}  // namespace

TEST_CASE("A plate is as thick as it is, whichever way it is turned") {
  const std::array<std::string, 6> turns{"",
                                         ":rotate(90, 0, 0)",
                                         ":rotate(0, 90, 0)",
                                         ":rotate(45, 0, 0)",
                                         ":rotate(45, 35.26, 0)",
                                         ":rotate(20, 30, 40)"};
  for (const std::string& turn : turns) {
    CAPTURE(turn);

    const FeatureSizes sizes = sizes_of("box(30, 20, 1)" + turn);

    REQUIRE(sizes.feature);
    CHECK(sizes.feature->mm == Approx(1).epsilon(kShare));
    CHECK_FALSE(sizes.gap);
  }
}

TEST_CASE("A slot is as wide as it is and where it is, whichever way it is turned") {
  for (const std::string turn :
       {"", ":rotate(90, 0, 0)", ":rotate(0, 0, 90)", ":rotate(20, 30, 40)"}) {
    CAPTURE(turn);

    const FeatureSizes sizes =
        sizes_of("difference(box(30, 20, 10), box(0.8, 8, 6):move(5, 0, 0))" + turn);

    REQUIRE(sizes.gap);
    CHECK(sizes.gap->mm == Approx(0.8).epsilon(kShare));
    REQUIRE(sizes.feature);
    CHECK(sizes.feature->mm == Approx(2).epsilon(kShare));  // above and below it
  }
  const auto at = sizes_of("difference(box(30, 20, 10), box(0.8, 8, 6):move(5, 0, 0))").gap->at;
  CHECK(at.x == Approx(5).margin(0.01));
  CHECK(std::abs(at.y) <= 4);
  CHECK(std::abs(at.z - 5) <= 3);
}

TEST_CASE("A rod is as thick as its diameter, and its axis is where it is thin") {
  for (const std::string turn : {"", ":rotate(90, 0, 0)", ":rotate(20, 30, 40)"}) {
    CAPTURE(turn);

    const FeatureSizes sizes = sizes_of("cylinder(1, 60)" + turn);

    REQUIRE(sizes.feature);
    CHECK(sizes.feature->mm == Approx(2).epsilon(kShare));
    CHECK_FALSE(sizes.gap);
  }
  const Vec3 at = sizes_of("cylinder(1, 60)").feature->at;
  CHECK(std::hypot(at.x, at.y) < 0.05);
}

TEST_CASE("A ball is as thick as its diameter, however small its sections are at the poles") {
  const FeatureSizes sizes = sizes_of("sphere(20)");

  REQUIRE(sizes.feature);
  CHECK(sizes.feature->mm == Approx(40).epsilon(kShare));
  CHECK(length(sizes.feature->at - Vec3{0, 0, 20}) < 40 * kShare);
  CHECK_FALSE(sizes.gap);
}

TEST_CASE("The gap between two balls is found where they are nearest") {
  const FeatureSizes sizes = sizes_of("union(sphere(10), sphere(10):move(15, 15, 0))");
  const double gap = std::sqrt(450.0) - 20;

  REQUIRE(sizes.gap);
  // The balls are taken for planes where the chord ends. It leans by 57 degrees at most, so that is
  // up to 0.76 of the gap beside the nearest points, and there planes are nearer by its square over
  // the radius.
  CHECK(sizes.gap->mm == Approx(gap).margin(0.76 * 0.76 * gap * gap / 10));
  CHECK(length(sizes.gap->at - Vec3{0, 0, 10}) < 1);
  REQUIRE(sizes.feature);
  CHECK(sizes.feature->mm == Approx(20).epsilon(kShare));
  CHECK_FALSE(sizes_of("union(sphere(10), sphere(10):move(14, 14, 0))").gap);
}

TEST_CASE("Edges and wedges have no thickness of their own") {
  const FeatureSizes cube = sizes_of("box(20, 20, 20):rotate(20, 30, 40)");
  const FeatureSizes cone = sizes_of("cone(10, 0, 40)");
  const FeatureSizes knife = sizes_of("intersection(box(30, 20, 2), half_space(1, 0, 3, 3))");

  REQUIRE(cube.feature);
  CHECK(cube.feature->mm == Approx(20).epsilon(kShare));
  CHECK_FALSE(cube.gap);
  CHECK_FALSE(cone.feature);
  REQUIRE(knife.feature);
  CHECK(knife.feature->mm > 2 * 0.9);  // as the header says
  CHECK(knife.feature->mm < 2 * (1 + kShare));
}

TEST_CASE("A gyroid's wall is found, and not the edges where it is cut off") {
  const FeatureSizes sizes = sizes_of("intersection(box(30, 30, 30), gyroid(10, 1.2))");

  REQUIRE(sizes.feature);
  CHECK(sizes.feature->mm > 1.2 * 0.8);  // locally 15 % thinner
  CHECK(sizes.feature->mm < 1.2 * 1.05);
  REQUIRE(sizes.gap);
  CHECK(sizes.gap->mm > 2);
}

TEST_CASE("The sampling wanted is below the smaller radius by the root of three") {
  const FeatureSizes sizes = sizes_of("difference(box(30, 20, 10), box(0.8, 8, 6))");

  REQUIRE(sizes.sampling_limit());
  CHECK(*sizes.radius() == Approx(0.4).epsilon(kShare));
  CHECK(*sizes.sampling_limit() == Approx(0.4 / std::sqrt(3.0)).epsilon(kShare));
  CHECK_FALSE(sizes_of("cone(10, 0, 40)").sampling_limit());
}
