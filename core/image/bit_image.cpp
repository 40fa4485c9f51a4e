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
