// The paper's propositions as laws over any bit image: separation of the samples, no crossing,
// closed sticks untouched, whatever the placement and the simplification.
#include <catch2/catch.hpp>
#include <functional>

#include "core/contour/audit.h"
#include "core/contour/place_laplacian.h"
#include "core/contour/place_smooth.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "tests/support/images.h"
#include "tests/support/outlines.h"

using namespace slipstick;

namespace {

constexpr int kNoiseImages = 10'000;
constexpr int kStructuredImages = 1'000;

void place_anyhow(ContourSet& contours, Rng& rng) {
  for (Place& place : contours.places()) {
    switch (rng.below(4)) {
      case 0:
        place = Place::clamped(Place::kLowest);
        break;
      case 1:
        place = Place::clamped(Place::kHighest);
        break;
      default:
        place = Place::clamped(static_cast<std::int64_t>(rng.below(65536)));
    }
  }
}

void place(ContourSet& contours, Rng& rng) {
  switch (rng.below(5)) {
    case 0:
      return;
    case 1:
      return place_sliding(contours);
    case 2:
      return place_projection(contours);
    case 3:
      return place_laplacian(contours);
    default:
      return place_anyhow(contours, rng);
  }
}

Simplified simplify(const ContourSet& contours, Rng& rng) {
  const SimplifyOptions options{rng.unit() < 0.5 ? 1.0 : rng.unit() * 0.1,
                                static_cast<int>(1 + rng.below(15))};
  switch (rng.below(6)) {
    case 0:
      return keep_all(contours);
    case 1:
    case 2:
    case 3:
      return simplify_fewest(contours, options);
    case 4:
      return simplify_greedy(contours, options);
    default:
      return simplify_vsa(contours, options);
  }
}

std::vector<Violation> broken_laws(const BitImage& image, Rng& rng) {
  const auto ambiguity = rng.below(2) == 0 ? Ambiguity::kSolid : Ambiguity::kVoid;
  ContourSet contours = trace(image, ambiguity);
  place(contours, rng);
  const Simplified simplified = simplify(contours, rng);
  const auto loops = test::audit_loops_of(simplified.outline);
  std::vector<Violation> violations = audit_loops(loops);
  for (const Violation& v : audit_sticks(loops, image.grid().width())) violations.push_back(v);
  for (const Violation& v : audit_samples(loops, image)) violations.push_back(v);
  return violations;
}

void hold(const std::function<BitImage(Rng&)>& draw, int images, std::uint64_t first_seed) {
  for (int i = 0; i < images; ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    Rng rng(seed);
    const BitImage image = draw(rng);
    const auto violations = broken_laws(image, rng);
    if (violations.empty()) continue;
    INFO("seed " << seed << ": " << describe(violations[0].kind) << " at " << violations[0].where.x
                 << ", " << violations[0].where.y);
    REQUIRE(violations.empty());
  }
}

}  // namespace

TEST_CASE("Simplified contours of any noise give the image back and never cross") {
  hold(
      [](Rng& rng) {
        const int columns = 1 + static_cast<int>(rng.below(16));
        const int rows = 1 + static_cast<int>(rng.below(16));
        return test::noise(rng, columns, rows, 0.1 + 0.8 * rng.unit());
      },
      kNoiseImages, 1);
}

TEST_CASE("Simplified contours of structured images give the image back and never cross") {
  hold([](Rng& rng) { return test::structured(rng); }, kStructuredImages, 1'000'000);
}
