// The same outlines, bit for bit, on every machine: `scripts/arm64` runs these too.
#include <catch2/catch.hpp>

#include "core/contour/place_roots.h"
#include "core/contour/place_smooth.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/formats/lua_script.h"
#include "core/image/sample.h"
#include "tests/support/images.h"

using namespace slipstick;

namespace {

// A hash of the points of outlines and of the edges before.
class Hash {
 public:
  void add(const Simplified& simplified) {
    add(simplified.edges_before);
    for (const Outline::Loop& loop : simplified.outline.loops()) {
      add(static_cast<std::uint64_t>(loop.depth));
      for (const GridPoint p : loop.points) {
        add(static_cast<std::uint64_t>(p.x) << 32 ^ static_cast<std::uint32_t>(p.y));
      }
    }
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  void add(std::uint64_t bits) {
    value_ = (value_ ^ bits) * 0x9E3779B97F4A7C15u;
    value_ ^= value_ >> 32;
  }
  std::uint64_t value_ = 0;
};

void add_all(Hash& hash, const ContourSet& contours, double tolerance) {
  const SimplifyOptions options{tolerance, 10};
  hash.add(keep_all(contours));
  hash.add(simplify_vsa(contours, options));
  hash.add(simplify_greedy(contours, options));
  hash.add(simplify_fewest(contours, options));
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
  Hash hash;
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
  Hash hash;
  for (int i = 0; i < 60; ++i) {
    const BitImage image = i % 2 == 0 ? test::structured(rng) : test::noise(rng, 20, 20, 0.45);
    ContourSet contours = trace(image, i % 3 == 0 ? Ambiguity::kVoid : Ambiguity::kSolid);
    i % 4 < 2 ? place_sliding(contours) : place_projection(contours);
    add_all(hash, contours, 0.03);
  }
  CHECK(hash.value() == 0x270e47debbb2647au);
}
