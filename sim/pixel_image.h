#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/box.h"
#include "core/base/vec.h"

namespace slipstick {

/// Where the judge's pixels lie: squares of side `size`, corners at whole multiples of it, so that
/// all frames of one size are windows of one raster. Its own, on purpose not the lattice that the
/// slicer samples on.
struct PixelFrame {
  Vec2 low;            ///< mm: the corner of column 0 and row 0.
  double size = 0.05;  ///< mm.
  int columns = 0;
  int rows = 0;
  std::int64_t first_column = 0;  ///< Which of the raster's columns is column 0.
  std::int64_t first_row = 0;

  /// The frame over `area` with an empty ring of pixels around it.
  [[nodiscard]] static PixelFrame over(const Box2& area, double size);

  [[nodiscard]] Vec2 centre(int column, int row) const {
    return {low.x + (column + 0.5) * size, centre_y(row)};
  }
  [[nodiscard]] double centre_y(int row) const { return low.y + (row + 0.5) * size; }
  /// The first column whose centre is at `x` or right of it, clamped to the frame.
  [[nodiscard]] int column_from(double x) const;
  [[nodiscard]] int row_from(double y) const;
};

/// A bit a pixel, 64 pixels a word.
class PixelImage {
 public:
  explicit PixelImage(const PixelFrame& frame);

  [[nodiscard]] const PixelFrame& frame() const { return frame_; }
  [[nodiscard]] std::span<const std::uint64_t> row(int r) const {
    return {words_.data() + static_cast<std::size_t>(r) * words_per_row_, words_per_row_};
  }
  [[nodiscard]] std::int64_t count() const;
  /// False beyond the frame.
  [[nodiscard]] bool at(int row, int column) const;

  /// Sets or clears the pixels of `row` in [begin, end).
  void set(int row, int begin, int end);
  void clear(int row, int begin, int end);

  /// Sets all pixels whose centre is no farther than width/2 from the segment, or than half a
  /// pixel's diagonal if that is more: a bead thinner than a pixel still hangs together.
  void draw_capsule(Vec2 a, Vec2 b, double width);
  /// With every pixel, its eight neighbours.
  [[nodiscard]] PixelImage grown() const;
  /// Without every pixel that has an unset one, or the border of the frame, for a neighbour.
  [[nodiscard]] PixelImage shrunk() const;
  [[nodiscard]] PixelImage inverted() const;
  /// What of it lies in `frame`. \pre Of the same size of pixels.
  [[nodiscard]] PixelImage within(const PixelFrame& frame) const;
  /// Removes what is in `other`. \pre Same frame.
  PixelImage& operator-=(const PixelImage& other);
  /// Adds what is in `other`. \pre Same frame.
  PixelImage& operator|=(const PixelImage& other);

  /// The pixels that are set here and not in `other`. \pre Same frame.
  [[nodiscard]] std::int64_t count_without(const PixelImage& other) const;

 private:
  template <typename Apply>
  void for_words(int row, int begin, int end, Apply apply);

  PixelFrame frame_;
  std::size_t words_per_row_;
  std::vector<std::uint64_t> words_;
};

}  // namespace slipstick
