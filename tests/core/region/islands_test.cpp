// Islands of layers, and what stands on what.
#include <catch2/catch.hpp>
#include <vector>

#include "core/region/islands.h"
#include "tests/support/images.h"

using namespace slipstick;

namespace {

using Rows = std::vector<std::string>;

// By flooding from each node, one at a time.
BitImage flooded(const BitImage& image, int column, int row) {
  BitImage island(image.grid());
  std::vector<std::pair<int, int>> front{{column, row}};
  while (!front.empty()) {
    const auto [c, r] = front.back();
    front.pop_back();
    if (!image.at(c, r) || island.at(c, r)) continue;
    island.set(c, r, true);
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) front.emplace_back(c + dc, r + dr);
    }
  }
  return island;
}

BitImage slowly_standing(const BitImage& image, const BitImage& below, const BitImage& cancelled) {
  BitImage standing(image.grid());
  for (int row = 0; row < image.rows(); ++row) {
    for (int column = 0; column < image.columns(); ++column) {
      if (!image.at(column, row)) continue;
      const BitImage island = flooded(image, column, row);
      const bool alone = (island & cancelled).any() && !(island & (below - cancelled)).any();
      if (alone) standing |= island;
    }
  }
  return standing;
}

}  // namespace

TEST_CASE("An island is found by a point in it, or near it, corners included") {
  const BitImage image = test::image_of({"##....", "..#...", "......", "....##"});
  const SliceGrid& grid = image.grid();
  const double width = grid.width();
  const double x = grid.node_x(2), y = grid.node_y(5);  // the top left node

  const Rows upper{"##....", "..#...", "......", "......"};
  CHECK(test::picture_of(island_at(image, x, y)) == upper);
  CHECK(test::picture_of(island_at(image, x - width, y + 0.4 * width)) == upper);
  CHECK(test::picture_of(island_at(image, x + 4.6 * width, y - 2.6 * width)) ==
        Rows{"......", "......", "......", "....##"});
}

TEST_CASE("Too far from everything there is no island") {
  const BitImage image = test::image_of({"##", "##"});
  const double x = image.grid().node_x(2), y = image.grid().node_y(2);

  CHECK(island_at(image, x - kIslandReach, y).any());
  CHECK_FALSE(island_at(image, x - 1.01 * kIslandReach, y).any());
  CHECK_FALSE(island_at(image, 1e300, y).any());
  CHECK_FALSE(island_at(BitImage(image.grid()), x, y).any());
}

TEST_CASE(
    "What stands on the cancelled alone is left out; what leans on others, or on nothing, stays") {
  const BitImage below = test::image_of({"##..##..##......", "##..##..##......"});
  const BitImage cancelled = test::image_of({"##......##......", "##......##......"});
  const BitImage image = test::image_of({"#####...###...##", "...............#"});

  CHECK(test::picture_of(standing_on(image, below, cancelled)) ==
        Rows{"........###.....", "................"});
}

TEST_CASE("Islands and what stands on them are as flooding finds them") {
  Rng rng(20261127);
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    const BitImage image = test::noise(rng, 70, 9, 0.35);
    const BitImage below = test::noise(rng, 70, 9, 0.3);
    const BitImage cancelled = below & test::noise(rng, 70, 9, 0.6);

    REQUIRE(standing_on(image, below, cancelled) == slowly_standing(image, below, cancelled));
    for (int node = 0; node < 5; ++node) {
      const int column = 2 + int(rng.below(70)), row = 2 + int(rng.below(9));
      if (!image.at(column, row)) continue;
      const auto island = island_at(image, image.grid().node_x(column), image.grid().node_y(row));
      REQUIRE(island == flooded(image, column, row));
    }
  }
}
