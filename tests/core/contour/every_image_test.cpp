// All 65,536 images of 4 x 4 samples: nothing small is left to chance.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

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

// The stick in the image that was turned by a quarter, of so many rows.
Stick turned_by_a_quarter(Stick stick, int rows) {
  return {static_cast<std::int16_t>(rows - 1 - stick.row), stick.column,
          static_cast<Outward>((static_cast<int>(stick.outward) + 1) % 4)};
}

// Depth and sticks of each loop, whatever their order.
using LoopSticks = std::pair<int, std::set<std::tuple<int, int, Outward>>>;
template <typename Map>
std::set<LoopSticks> loops_of(const ContourSet& contours, Map map) {
  std::set<LoopSticks> loops;
  for (const ContourSet::Loop& loop : contours.loops()) {
    LoopSticks sticks{loop.depth, {}};
    for (const Stick& stick : contours.sticks(loop)) {
      const Stick s = map(stick);
      sticks.second.insert({s.column, s.row, s.outward});
    }
    loops.insert(sticks);
  }
  return loops;
}

int of_parity(const ContourSet& contours, int parity) {
  return static_cast<int>(
      std::count_if(contours.loops().begin(), contours.loops().end(),
                    [parity](const ContourSet::Loop& loop) { return loop.depth % 2 == parity; }));
}

// The first images, as numbers, for which `holds` is false: nothing but what is wrong is printed.
template <typename Law>
std::vector<unsigned> exceptions(unsigned stride, Law holds) {
  std::vector<unsigned> images;
  for (unsigned bits = 0; bits < kImages && images.size() < 10; bits += stride) {
    if (!holds(bits)) images.push_back(bits);
  }
  return images;
}

const std::vector<unsigned> kNone;

}  // namespace

TEST_CASE("Every small image has a loop for each component and each hole, every stick in one") {
  const auto wrong = exceptions(1, [](unsigned bits) {
    const BitImage image = image_of_bits(bits);
    const ContourSet solid = trace(image, Ambiguity::kSolid);
    const ContourSet apart = trace(image, Ambiguity::kVoid);
    const std::size_t sticks = test::count_sticks(image);
    return solid.sticks().size() == sticks && apart.sticks().size() == sticks &&
           of_parity(solid, 0) == test::components(image, 8) &&
           of_parity(solid, 1) == test::holes(image, 4) &&
           of_parity(apart, 0) == test::components(image, 4) &&
           of_parity(apart, 1) == test::holes(image, 8);
  });

  CHECK(wrong == kNone);
}

TEST_CASE("A turned image has the turned loops, stick by stick") {
  const auto wrong = exceptions(1, [](unsigned bits) {
    const BitImage image = image_of_bits(bits);
    const BitImage turned = image_of_bits(turned_by_a_quarter(bits));
    const auto turn = [&](Stick s) { return turned_by_a_quarter(s, image.rows()); };
    const auto same = [](Stick s) { return s; };
    return loops_of(trace(turned, Ambiguity::kSolid), same) ==
           loops_of(trace(image, Ambiguity::kSolid), turn);
  });

  CHECK(wrong == kNone);
}

TEST_CASE("Every small image comes back from its fewest edges") {
  Rng rng(5);
  // One in seven: all of them take eight seconds under the sanitizers.
  const auto wrong = exceptions(7, [&rng](unsigned bits) {
    const BitImage image = image_of_bits(bits);
    ContourSet contours = trace(image, bits % 2 == 0 ? Ambiguity::kSolid : Ambiguity::kVoid);
    for (Place& place : contours.places()) {
      place = Place::clamped(static_cast<std::int64_t>(rng.below(65537)));
    }
    const auto loops = test::audit_loops_of(simplify_fewest(contours, {0.05, 10}).outline);
    return audit_loops(loops).empty() && audit_samples(loops, image).empty();
  });

  CHECK(wrong == kNone);
}
