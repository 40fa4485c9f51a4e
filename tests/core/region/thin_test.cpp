#include "core/region/thin.h"

#include <catch2/catch.hpp>

#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "tests/support/flood.h"
#include "tests/support/images.h"

using namespace slipstick;

namespace {

struct Counts {
  int components;
  int holes;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts(const BitImage& image, Ambiguity ambiguity) {
  const bool solid = ambiguity == Ambiguity::kSolid;
  return {test::components(image, solid ? 8 : 4), test::holes(image, solid ? 4 : 8)};
}

constexpr int kAround[8][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                               {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

}  // namespace

TEST_CASE("A simple point is one whose change changes no count, for every neighbourhood") {
  for (unsigned set = 0; set < 256; ++set) {
    BitImage with(test::small_grid(5, 5));
    for (unsigned i = 0; i < 8; ++i) {
      if ((set >> i & 1) != 0) with.set(4 + kAround[i][0], 4 + kAround[i][1], true);
    }
    BitImage without = with;
    with.set(4, 4, true);
    for (const Ambiguity ambiguity : {Ambiguity::kSolid, Ambiguity::kVoid}) {
      INFO("neighbours " << set);
      CHECK(neighbourhood(with, 4, 4) == set);
      // Alone in the plane, equal counts and a simple point are the same thing, but for a hole that
      // opens where a component vanishes.
      const bool same = counts(with, ambiguity) == counts(without, ambiguity);
      if (is_simple(static_cast<Neighbourhood>(set), ambiguity)) CHECK(same);
      if (!same) CHECK_FALSE(is_simple(static_cast<Neighbourhood>(set), ambiguity));
    }
  }
}

TEST_CASE("Thinning keeps every component and every hole") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Rng rng(seed);
    const BitImage image = seed % 2 == 0 ? test::noise(rng, 20, 20, 0.6) : test::structured(rng);
    const auto ambiguity = seed % 3 == 0 ? Ambiguity::kVoid : Ambiguity::kSolid;
    const Outline outline = keep_all(trace(image, ambiguity)).outline;
    const DistanceField depth(image, outline, 1.0);
    const BitImage kept = depth.at_least(0.125 * (1 + static_cast<double>(rng.below(3))));
    INFO("seed " << seed);

    const BitImage lines = thinned(image, kept, depth, {rng.unit() * 0.2, ambiguity});

    CHECK((lines - image).any() == false);
    CHECK((kept - lines).any() == false);
    CHECK(counts(lines, ambiguity) == counts(image, ambiguity));
  }
}
