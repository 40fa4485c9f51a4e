// All 65,536 images of 4 x 4 samples: nothing small is left to chance.
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/contour/audit.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "tests/support/flood.h"
#include "tests/support/images.h"
#include "tests/support/outlines.h"

using namespace slipstick;

namespace {

constexpr int kSide = 4;
constexpr unsigned kImages = 1u << (kSide * kSide);

// Bit 4·row + column of `bits` is a sample.
BitImage image_of_bits(unsigned bits) {
  BitImage image(test::small_grid(kSide, kSide));
  const int margin = (image.columns() - kSide) / 2;
  for (int i = 0; i < kSide * kSide; ++i) {
    image.set(margin + i % kSide, margin + i / kSide, (bits >> i & 1u) != 0);
  }
  return image;
}

unsigned turned_by_a_quarter(unsigned bits) {
  unsigned turned = 0;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      if ((bits >> (kSide * row + column) & 1u) == 0) continue;
      turned |= 1u << (kSide * column + kSide - 1 - row);
    }
  }
  return turned;
}

// (depth, sticks) of all loops, in order.
std::vector<std::pair<int, std::size_t>> loops_of(const ContourSet& contours) {
  std::vector<std::pair<int, std::size_t>> loops;
  for (const ContourSet::Loop& loop : contours.loops()) loops.emplace_back(loop.depth, loop.count);
  std::sort(loops.begin(), loops.end());
  return loops;
}

std::size_t of_depth(const ContourSet& contours, int parity) {
  return static_cast<std::size_t>(
      std::count_if(contours.loops().begin(), contours.loops().end(),
                    [parity](const ContourSet::Loop& loop) { return loop.depth % 2 == parity; }));
}

}  // namespace

TEST_CASE("Every small image has a loop for each component and each hole, every stick in one") {
  for (unsigned bits = 0; bits < kImages; ++bits) {
    const BitImage image = image_of_bits(bits);
    for (const auto ambiguity : {Ambiguity::kSolid, Ambiguity::kVoid}) {
      const ContourSet contours = trace(image, ambiguity);
      const int solid = ambiguity == Ambiguity::kSolid ? 8 : 4;

      if (contours.sticks().size() != test::count_sticks(image) ||
          of_depth(contours, 0) != static_cast<std::size_t>(test::components(image, solid)) ||
          of_depth(contours, 1) != static_cast<std::size_t>(test::holes(image, 12 - solid))) {
        FAIL("image " << bits);
      }
    }
  }
}

TEST_CASE("A turned image has the turned loops") {
  for (unsigned bits = 0; bits < kImages; ++bits) {
    const auto loops = loops_of(trace(image_of_bits(bits), Ambiguity::kSolid));
    const BitImage turned = image_of_bits(turned_by_a_quarter(bits));

    if (loops_of(trace(turned, Ambiguity::kSolid)) != loops) FAIL("image " << bits);
  }
}

TEST_CASE("Every small image comes back from its fewest edges") {
  // One in seven: all of them take eight seconds under the sanitizers.
  Rng rng(5);
  for (unsigned bits = 0; bits < kImages; bits += 7) {
    const BitImage image = image_of_bits(bits);
    ContourSet contours = trace(image, bits % 2 == 0 ? Ambiguity::kSolid : Ambiguity::kVoid);
    for (Place& place : contours.places()) {
      place = Place::clamped(static_cast<std::int64_t>(rng.below(65537)));
    }

    const auto loops = test::audit_loops_of(simplify_fewest(contours, {0.05, 10}).outline);

    if (!audit_loops(loops).empty() || !audit_samples(loops, image).empty()) {
      FAIL("image " << bits);
    }
  }
}
