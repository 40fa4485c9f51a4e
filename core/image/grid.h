#pragma once

#include <cstdint>

#include "core/base/box.h"
#include "core/base/result.h"

namespace slipstick {

/// The square lattice on which one print is sampled, and the window of it that holds the solid.
///
/// Nodes lie at whole multiples of the grid width h (the paper's r'), so all layers of a print and
/// all prints of one h share one lattice. h is a whole number of 2^-22 mm and a window has at most
/// 2^14 nodes a side, so that every coordinate of a contour, (column + k/65536)·h, is exactly a
/// double: what is printed in millimetres is the very point that was verified.
class SliceGrid {
 public:
  static constexpr int kNodesMax = 1 << 14;
  static constexpr double kWidthMax = 2.0;
  static constexpr double kWidthMin = 0.002;

  /// The lattice of the largest width h <= `sampling` over `area`, with a ring of nodes outside it.
  ///
  /// \return kInput if `sampling` is out of range, `area` is empty or not finite, or the window
  /// would
  ///   have more than `kNodesMax` nodes a side (the message says which sampling would do).
  [[nodiscard]] static Result<SliceGrid> over(const Box2& area, double sampling);

  /// Columns and rows of nodes, the outer ring included.
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  /// The grid width h in mm.
  [[nodiscard]] double width() const { return width_; }
  /// Which lattice line column 0 and row 0 are.
  [[nodiscard]] std::int64_t first_column() const { return first_column_; }
  [[nodiscard]] std::int64_t first_row() const { return first_row_; }

  /// Millimetres of `column + k/65536`, given as column·65536 + k. Exact.
  [[nodiscard]] double x_of(std::int64_t units) const {
    return static_cast<double>(units + first_column_ * kUnitsPerCell) * unit();
  }
  [[nodiscard]] double y_of(std::int64_t units) const {
    return static_cast<double>(units + first_row_ * kUnitsPerCell) * unit();
  }
  [[nodiscard]] double node_x(int column) const { return x_of(column * kUnitsPerCell); }
  [[nodiscard]] double node_y(int row) const { return y_of(row * kUnitsPerCell); }

  /// Parts of a cell that places on sticks are counted in.
  static constexpr std::int64_t kUnitsPerCell = 1 << 16;
  /// One such part in mm.
  [[nodiscard]] double unit() const { return width_ / static_cast<double>(kUnitsPerCell); }

  friend bool operator==(const SliceGrid&, const SliceGrid&) = default;

 private:
  SliceGrid() = default;

  double width_ = 0;
  std::int64_t first_column_ = 0;
  std::int64_t first_row_ = 0;
  int columns_ = 0;
  int rows_ = 0;
};

}  // namespace slipstick
