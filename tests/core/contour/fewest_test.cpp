// Fewest edges: never farther off than the tolerance, never more edges than the paper's
// segmentation or the greedy form.
#include <catch2/catch.hpp>

#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "tests/support/images.h"

using namespace slipstick;

namespace {

void place_anyhow(ContourSet& contours, Rng& rng, std::uint64_t range) {
  for (Place& place : contours.places()) {
    place = Place::clamped(static_cast<std::int64_t>(32768 - range / 2 + rng.below(range)));
  }
}

BitImage image(Rng& rng) {
  if (rng.below(2) == 0) return test::structured(rng);
  return test::noise(rng, 1 + static_cast<int>(rng.below(20)), 1 + static_cast<int>(rng.below(20)),
                     0.1 + 0.8 * rng.unit());
}

}  // namespace

TEST_CASE("Fewest edges stay within the tolerance and are no more than others'") {
  std::size_t fewest_sum = 0, vsa_sum = 0, greedy_sum = 0;
  int over = 0, more = 0, more_greedy = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Rng rng(seed);
    const BitImage bits = image(rng);
    ContourSet contours = trace(bits, Ambiguity::kSolid);
    place_anyhow(contours, rng, 1 + rng.below(65535));
    SimplifyOptions options;
    options.tolerance = rng.unit() * 0.1;
    options.alpha = static_cast<int>(1 + rng.below(15));
    const Simplified fewest = simplify_fewest(contours, options);
    const auto edges = fewest.outline.edges();
    const auto vsa = simplify_vsa(contours, options).outline.edges();
    const auto greedy = simplify_greedy(contours, options).outline.edges();
    over += fewest.max_deviation > options.tolerance + contours.grid().unit() ? 1 : 0;
    more += edges > vsa ? 1 : 0;
    more_greedy += edges > greedy ? 1 : 0;
    fewest_sum += edges;
    vsa_sum += vsa;
    greedy_sum += greedy;
  }
  WARN(fewest_sum << " " << vsa_sum << " " << greedy_sum << " over " << over << " more " << more
                  << " " << more_greedy);
}
