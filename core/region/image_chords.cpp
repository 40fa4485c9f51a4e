#include "core/region/image_chords.h"

#include <bit>
#include <cstdint>

namespace slipstick {
namespace {

constexpr int kNone = -1;

// Calls `visit(column)` for every bit of a word of a row, lowest first.
template <typename Visit>
void for_each_bit(std::uint64_t word, std::size_t index, Visit visit) {
  for (; word != 0; word &= word - 1) {
    visit(static_cast<int>(index) * BitImage::kBitsPerWord + std::countr_zero(word));
  }
}

void add_rows(const BitImage& image, std::vector<ImageChord>& chords) {
  for (int row = 0; row < image.rows(); ++row) {
    const auto words = image.row(row);
    int begin = kNone;
    bool inside = false;
    std::uint64_t carried = 0;  // the node before this word
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::uint64_t changes = words[i] ^ (words[i] << 1 | carried);
      carried = words[i] >> (BitImage::kBitsPerWord - 1);
      for_each_bit(changes, i, [&](int column) {
        if (begin != kNone) chords.push_back({SectionAxis::kX, row, begin, column, inside});
        begin = column;
        inside = !inside;
      });
    }
  }
}

void add_columns(const BitImage& image, std::vector<ImageChord>& chords) {
  std::vector<int> begin(static_cast<std::size_t>(image.columns()), kNone);
  for (int row = 1; row < image.rows(); ++row) {
    const auto below = image.row(row - 1);
    const auto words = image.row(row);
    for (std::size_t i = 0; i < words.size(); ++i) {
      for_each_bit(words[i] ^ below[i], i, [&](int column) {
        int& first = begin[static_cast<std::size_t>(column)];
        const bool inside = !image.at(column, row);
        if (first != kNone) chords.push_back({SectionAxis::kY, column, first, row, inside});
        first = row;
      });
    }
  }
}

}  // namespace

std::vector<ImageChord> chords_of(const BitImage& image) {
  std::vector<ImageChord> chords;
  add_rows(image, chords);
  add_columns(image, chords);
  return chords;
}

}  // namespace slipstick
