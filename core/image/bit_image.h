#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/check.h"
#include "core/image/grid.h"

namespace slipstick {

/// The paper's binary image: one bit a node of the lattice, 1 inside the solid (section 3.1).
///
/// Invariant: the outermost ring of nodes is outside, so that every contour closes.
class BitImage {
 public:
  static constexpr int kBitsPerWord = 64;

  explicit BitImage(const SliceGrid& grid)
      : grid_(grid),
        words_per_row_((grid.columns() + kBitsPerWord - 1) / kBitsPerWord),
        words_(static_cast<std::size_t>(words_per_row_) * static_cast<std::size_t>(grid.rows())) {}

  [[nodiscard]] const SliceGrid& grid() const { return grid_; }
  [[nodiscard]] int columns() const { return grid_.columns(); }
  [[nodiscard]] int rows() const { return grid_.rows(); }

  /// False also beyond the window: all the rest of the plane is outside.
  [[nodiscard]] bool at(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns() || row >= rows()) return false;
    return ((words_[index(column, row)] >> (column % kBitsPerWord)) & 1u) != 0;
  }

  /// \pre The node is in the window and not on its outermost ring.
  void set(int column, int row, bool inside) {
    SLIPSTICK_DCHECK(column > 0 && row > 0 && column < columns() - 1 && row < rows() - 1);
    const std::uint64_t bit = std::uint64_t{1} << (column % kBitsPerWord);
    std::uint64_t& word = words_[index(column, row)];
    word = inside ? word | bit : word & ~bit;
  }

  /// Sets a rectangle of nodes inside. \pre As for `set`, for each of them.
  void fill(int column, int row, int columns, int rows);

  /// Sets the nodes from `column` on inside where `bits` has a 1, lowest first; leaves the others.
  /// \pre As for `set`, for each of them; all lie in one word of the row.
  void set_bits(int column, int row, std::uint64_t bits) {
    [[maybe_unused]] const int width = kBitsPerWord - std::countl_zero(bits);
    SLIPSTICK_DCHECK(bits == 0 ||
                     (column > 0 && row > 0 && row < rows() - 1 && column + width < columns() &&
                      column % kBitsPerWord + width <= kBitsPerWord));
    words_[index(column, row)] |= bits << (column % kBitsPerWord);
  }

  /// One row, 64 nodes a word, lowest bit first, zeros behind the last column.
  [[nodiscard]] std::span<const std::uint64_t> row(int row) const {
    return std::span(words_).subspan(index(0, row), static_cast<std::size_t>(words_per_row_));
  }

  [[nodiscard]] bool any() const;
  /// How many nodes are inside.
  [[nodiscard]] std::int64_t count() const;

  friend bool operator==(const BitImage&, const BitImage&) = default;

  // Set algebra of images. \pre Both are on one grid.
  BitImage& operator&=(const BitImage& other);
  BitImage& operator|=(const BitImage& other);
  /// Removes what is in `other`.
  BitImage& operator-=(const BitImage& other);

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(words_per_row_) +
           static_cast<std::size_t>(column / kBitsPerWord);
  }

  SliceGrid grid_;
  int words_per_row_;
  std::vector<std::uint64_t> words_;
};

[[nodiscard]] inline BitImage operator&(BitImage a, const BitImage& b) {
  return a &= b;
}
[[nodiscard]] inline BitImage operator|(BitImage a, const BitImage& b) {
  return a |= b;
}
[[nodiscard]] inline BitImage operator-(BitImage a, const BitImage& b) {
  return a -= b;
}

}  // namespace slipstick
