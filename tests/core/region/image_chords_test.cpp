// Chords of an image against looking at every node.
#include "core/region/image_chords.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <tuple>
#include <vector>

#include "tests/support/images.h"

using namespace slipstick;

namespace {

using Row = std::tuple<SectionAxis, int, int, int, bool>;

// A line node by node.
template <typename At>
void add_line(std::vector<Row>& rows, SectionAxis axis, int line, int size, At at) {
  int begin = -1;
  for (int i = 1; i < size; ++i) {
    if (at(i) == at(i - 1)) continue;
    if (begin >= 0) rows.emplace_back(axis, line, begin, i, at(i - 1));
    begin = i;
  }
}

std::vector<Row> obvious(const BitImage& image) {
  std::vector<Row> rows;
  for (int row = 0; row < image.rows(); ++row) {
    add_line(rows, SectionAxis::kX, row, image.columns(),
             [&](int column) { return image.at(column, row); });
  }
  for (int column = 0; column < image.columns(); ++column) {
    add_line(rows, SectionAxis::kY, column, image.rows(),
             [&](int row) { return image.at(column, row); });
  }
  return rows;
}

std::vector<Row> fast(const BitImage& image) {
  std::vector<Row> rows;
  for (const ImageChord& c : chords_of(image)) {
    rows.emplace_back(c.axis, c.line, c.begin, c.end, c.inside);
  }
  return rows;
}

std::vector<Row> sorted(std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace

TEST_CASE("The chords of an image are its runs between two changes") {
  Rng rng(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int columns = 3 + static_cast<int>(rng.below(200));
    const BitImage image =
        trial % 2 == 0 ? test::noise(rng, columns, 20, 0.5) : test::structured(rng);

    CHECK(sorted(fast(image)) == sorted(obvious(image)));
  }
}
