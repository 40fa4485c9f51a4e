#include "core/contour/trace.h"

#include <catch2/catch.hpp>
#include <set>
#include <tuple>

#include "tests/support/flood.h"
#include "tests/support/images.h"

using namespace slipstick;
using test::image_of;

namespace {

std::vector<int> depths(const ContourSet& contours) {
  std::vector<int> result;
  for (const auto& loop : contours.loops()) result.push_back(loop.depth);
  return result;
}

int outer_loops(const ContourSet& contours) {
  int count = 0;
  for (const auto& loop : contours.loops()) count += loop.depth % 2 == 0 ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("An empty image has no contour") {
  CHECK(trace(image_of({"..", ".."}), Ambiguity::kSolid).loops().empty());
}

TEST_CASE("A single sample has one loop of four sticks") {
  const ContourSet contours = trace(image_of({"#"}), Ambiguity::kSolid);

  REQUIRE(contours.loops().size() == 1);
  CHECK(contours.loops()[0].count == 4);
}

TEST_CASE("Depth counts the loops around") {
  const ContourSet contours = trace(image_of({"#######",  //
                                              "#.....#",  //
                                              "#.###.#",  //
                                              "#.#.#.#",  //
                                              "#.###.#",  //
                                              "#.....#",  //
                                              "#######"}),
                                    Ambiguity::kSolid);

  CHECK(depths(contours) == std::vector<int>{0, 1, 2, 3});
}

TEST_CASE("An island beside a hole is not in it") {
  const ContourSet contours = trace(image_of({"####..",  //
                                              "#.##.#",  //
                                              "####.."}),
                                    Ambiguity::kSolid);

  CHECK(depths(contours) == std::vector<int>{0, 1, 0});
}

TEST_CASE("An ambiguous square joins the solid or the void as asked") {
  const BitImage diagonal = image_of({"#.", ".#"});

  CHECK(trace(diagonal, Ambiguity::kSolid).loops().size() == 1);
  CHECK(trace(diagonal, Ambiguity::kVoid).loops().size() == 2);
  CHECK(trace(diagonal, Ambiguity::kSolid).ambiguous_squares() == 1);
  CHECK(trace(diagonal, Ambiguity::kVoid).ambiguous_squares() == 1);
}

TEST_CASE("Every stick of any image is in exactly one loop, and loops are components and holes") {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Rng rng(seed);
    const BitImage image = seed % 2 == 0 ? test::noise(rng, 20, 20, 0.45) : test::structured(rng);
    const auto ambiguity = seed % 3 == 0 ? Ambiguity::kVoid : Ambiguity::kSolid;
    INFO("seed " << seed);

    const ContourSet contours = trace(image, ambiguity);

    std::set<std::tuple<int, int, int>> sticks;
    for (const Stick& s : contours.sticks()) {
      const Step e = step(s.outward);
      REQUIRE(image.at(s.column, s.row));
      REQUIRE_FALSE(image.at(s.column + e.x, s.row + e.y));
      sticks.insert({s.column, s.row, static_cast<int>(s.outward)});
    }
    REQUIRE(sticks.size() == contours.sticks().size());
    REQUIRE(sticks.size() == test::count_sticks(image));
    const bool solid = ambiguity == Ambiguity::kSolid;
    REQUIRE(outer_loops(contours) == test::components(image, solid ? 8 : 4));
    REQUIRE(static_cast<int>(contours.loops().size()) - outer_loops(contours) ==
            test::holes(image, solid ? 4 : 8));
  }
}
