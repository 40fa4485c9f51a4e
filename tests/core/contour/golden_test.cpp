// The same outlines, bit for bit, on every machine: `scripts/arm64` runs these too.
#include <catch2/catch.hpp>

#include "core/contour/place_roots.h"
#include "core/contour/place_smooth.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/formats/lua_script.h"
#include "core/image/sample.h"
#include "tests/support/bit_hash.h"
#include "tests/support/images.h"

using namespace slipstick;

namespace {

// The points of outlines and the edges before.
void add(test::BitHash& hash, const Simplified& simplified) {
  hash.add(simplified.edges_before);
  for (const Outline::Loop& loop : simplified.outline.loops()) {
    hash.add(static_cast<std::uint64_t>(loop.depth));
    for (const GridPoint p : loop.points) {
      hash.add(static_cast<std::uint64_t>(p.x) << 32 ^ static_cast<std::uint32_t>(p.y));
    }
  }
}

void add_all(test::BitHash& hash, const ContourSet& contours, double tolerance) {
  const SimplifyOptions options{tolerance, 10};
  add(hash, keep_all(contours));
  add(hash, simplify_vsa(contours, options));
  add(hash, simplify_greedy(contours, options));
  add(hash, simplify_fewest(contours, options));
}

}  // namespace

TEST_CASE("Outlines of a solid are the same on every machine", "[golden]") {
  const auto model = load_lua_model(
      "local k = 2 * math.pi / 7\n"
      "local g = sin(k * x) * cos(k * y) + sin(k * y) * cos(k * z) + sin(k * z) * cos(k * x)\n"
      "return max(g, sqrt(x ^ 2 + y ^ 2 + z ^ 2) - 9):bounds(-10, -10, -10, 10, 10, 10)",
      "golden.lua");
  REQUIRE(model);
  const auto solid = (*model)->placed({});
  test::BitHash hash;
  for (const double z : {-6.25, -1.0, 0.375, 3.3}) {
    const auto section = solid->section(z);
    const auto image = sample(*section, *SliceGrid::over({{-10, -10}, {10, 10}}, 0.125));
    REQUIRE(image);
    ContourSet contours = trace(*image, Ambiguity::kSolid);
    place_roots(contours, *section);
    add_all(hash, contours, 0.0125);
  }
  CHECK(hash.value() == 0x6e9a802462594d18u);
}

TEST_CASE("Outlines of bit images are the same on every machine", "[golden]") {
  Rng rng(11);
  test::BitHash hash;
  for (int i = 0; i < 60; ++i) {
    const BitImage image = i % 2 == 0 ? test::structured(rng) : test::noise(rng, 20, 20, 0.45);
    ContourSet contours = trace(image, i % 3 == 0 ? Ambiguity::kVoid : Ambiguity::kSolid);
    i % 4 < 2 ? place_sliding(contours) : place_projection(contours);
    add_all(hash, contours, 0.03);
  }
  CHECK(hash.value() == 0x270e47debbb2647au);
}
