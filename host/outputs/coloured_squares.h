#pragma once

#include <cairo.h>

#include <cstdint>
#include <functional>

namespace slipstick {

/// Rows and columns of coloured squares, the lowest row at the bottom.
struct ColouredSquares {
  int columns = 0;
  int rows = 0;
  std::function<std::uint32_t(int row, int column)> colour;  ///< 0xRRGGBB
};

/// Paints `squares` with its upper left corner at (`x`, `y`), each square `side` wide; sharp unless
/// squares are smaller than one unit.
void paint_squares(cairo_t* cairo, const ColouredSquares& squares, double x, double y, double side);

}  // namespace slipstick
