#include "core/image/bit_image.h"

#include <algorithm>
#include <bit>

namespace slipstick {

bool BitImage::any() const {
  return std::any_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word != 0; });
}

std::int64_t BitImage::count() const {
  std::int64_t sum = 0;
  for (const std::uint64_t word : words_) sum += std::popcount(word);
  return sum;
}

void BitImage::fill(int column, int row, int columns, int rows) {
  if (columns <= 0 || rows <= 0) return;
  SLIPSTICK_DCHECK(column > 0 && row > 0 && column + columns < this->columns() &&
                   row + rows < this->rows());
  const std::size_t first = index(column, row), last = index(column + columns - 1, row);
  const std::uint64_t head = ~std::uint64_t{0} << (column % kBitsPerWord);
  const std::uint64_t tail =
      ~std::uint64_t{0} >> (kBitsPerWord - 1 - (column + columns - 1) % kBitsPerWord);
  for (int r = 0; r < rows; ++r) {
    const std::size_t shift =
        static_cast<std::size_t>(r) * static_cast<std::size_t>(words_per_row_);
    std::uint64_t* const words = words_.data() + shift;
    if (first == last) {
      words[first] |= head & tail;
      continue;
    }
    words[first] |= head;
    std::fill(words + first + 1, words + last, ~std::uint64_t{0});
    words[last] |= tail;
  }
}

BitImage& BitImage::operator&=(const BitImage& other) {
  SLIPSTICK_CHECK(grid_ == other.grid_);
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
  return *this;
}

BitImage& BitImage::operator|=(const BitImage& other) {
  SLIPSTICK_CHECK(grid_ == other.grid_);
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
  return *this;
}

BitImage& BitImage::operator-=(const BitImage& other) {
  SLIPSTICK_CHECK(grid_ == other.grid_);
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~other.words_[i];
  return *this;
}

}  // namespace slipstick
