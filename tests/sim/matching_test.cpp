#include "sim/matching.h"

#include <catch2/catch.hpp>
#include <string>

#include "sim/pixel_image.h"

using namespace slipstick;

namespace {

// One row of pixels, `#` set.
Regions row(const std::string& pixels) {
  PixelImage image(PixelFrame::over({{0, 0}, {5, 1}}, 1));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int column = static_cast<int>(i) + 1;
    if (pixels[i] == '#') image.set(1, column, column + 1);
  }
  return Regions::of_set(image);
}

}  // namespace

TEST_CASE("A wanted part smaller than a speck meets one printed part, however it is shared") {
  constexpr std::int64_t kSpeck = 4;

  const auto met = meetings(row("#####"), row("##.##"), kSpeck);

  REQUIRE(met.size() == 1);
  CHECK(met[0].b == 0);
}

TEST_CASE("A wanted part meets each printed part that has a speck of it, and the largest") {
  CHECK(meetings(row("#####"), row("##.##"), 2).size() == 2);

  const auto met = meetings(row("#####"), row("#.###"), 4);

  REQUIRE(met.size() == 1);
  CHECK(met[0].b == 1);
}
