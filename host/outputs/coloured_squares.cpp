#include "host/outputs/coloured_squares.h"

#include <cstddef>
#include <cstring>
#include <memory>

namespace slipstick {
namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;

/// One pixel each.
Surface surface_of(const ColouredSquares& squares) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, squares.columns, squares.rows));
  cairo_surface_flush(surface.get());
  unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  if (bytes == nullptr) return surface;
  for (int row = 0; row < squares.rows; ++row) {
    unsigned char* line = bytes + static_cast<std::ptrdiff_t>(squares.rows - 1 - row) * stride;
    for (int column = 0; column < squares.columns; ++column) {
      const std::uint32_t colour = squares.colour(row, column);
      std::memcpy(line + 4 * static_cast<std::ptrdiff_t>(column), &colour, sizeof colour);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

}  // namespace

void paint_squares(cairo_t* cairo, const ColouredSquares& squares, double x, double y,
                   double side) {
  const Surface surface = surface_of(squares);
  cairo_save(cairo);
  cairo_translate(cairo, x, y);
  cairo_scale(cairo, side, side);
  cairo_set_source_surface(cairo, surface.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo),
                           side < 1 ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

}  // namespace slipstick
