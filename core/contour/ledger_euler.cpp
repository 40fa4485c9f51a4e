#include "core/contour/ledger_euler.h"

#include <bit>

namespace slipstick {
namespace {

using Word = std::uint64_t;

// Two rows of an image, one above the other, word by word, each also moved one column to the right.
// The outer ring is outside, so nothing is lost at the ends.
struct TwoRows {
  Word lower = 0, upper = 0;            // a cell, and the one above it
  Word lower_left = 0, upper_left = 0;  // their left neighbours
};

TwoRows two_rows(const BitImage& image, int row, std::size_t w) {
  const auto lower = image.row(row - 1), upper = image.row(row);
  const auto moved = [w](std::span<const Word> words) {
    return words[w] << 1 | (w == 0 ? 0 : words[w - 1] >> (BitImage::kBitsPerWord - 1));
  };
  return {lower[w], upper[w], moved(lower), moved(upper)};
}

// The corner, the two sides and the cell that belong to each node, as bits.
struct Parts {
  Word corners = 0, sides = 0, uprights = 0, cells = 0;
};

Parts closed_parts(const TwoRows& r) {
  return {r.lower | r.upper | r.lower_left | r.upper_left, r.lower | r.upper,
          r.upper | r.upper_left, r.upper};
}

Parts open_parts(const TwoRows& r) {
  return {r.lower & r.upper & r.lower_left & r.upper_left, r.lower & r.upper,
          r.upper & r.upper_left, r.upper};
}

Parts parts(const TwoRows& rows, Touch touch) {
  return touch == Touch::kCorners ? closed_parts(rows) : open_parts(rows);
}

std::int64_t count(const Parts& p) {
  return std::popcount(p.corners) - std::popcount(p.sides) - std::popcount(p.uprights) +
         std::popcount(p.cells);
}

Parts in_both(const Parts& a, const Parts& b) {
  return {a.corners & b.corners, a.sides & b.sides, a.uprights & b.uprights, a.cells & b.cells};
}

}  // namespace

std::int64_t euler_number(const BitImage& image, Touch touch) {
  return euler_number_in_common(image, image, touch);
}

std::int64_t euler_number_in_common(const BitImage& a, const BitImage& b, Touch touch) {
  SLIPSTICK_CHECK(a.grid() == b.grid());
  std::int64_t sum = 0;
  for (int row = 1; row < a.rows(); ++row) {
    for (std::size_t w = 0; w < a.row(row).size(); ++w) {
      sum += count(in_both(parts(two_rows(a, row, w), touch), parts(two_rows(b, row, w), touch)));
    }
  }
  return sum;
}

}  // namespace slipstick
