#include "host/figures/image_figure.h"

#include <algorithm>

#include "host/outputs/canvas.h"
#include "host/outputs/coloured_squares.h"

namespace slipstick {
namespace {

constexpr int kNodePixelsMax = 24;
constexpr int kDiscPixels = 8;  // smaller ones would not be round
constexpr std::uint32_t kInside = 0x202020, kOutside = 0xFFFFFF;

// Strokes of no length with round ends are discs, and the shortest way to say so in SVG.
class Discs {
 public:
  Discs(cairo_t* cairo, const BitImage& image, const NodeWindow& nodes, int side)
      : cairo_(cairo), image_(image), nodes_(nodes), side_(side) {
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  }

  void draw(bool inside, double share, double grey) const {
    cairo_set_source_rgb(cairo_, grey, grey, grey);
    cairo_set_line_width(cairo_, share * side_);
    for (int row = nodes_.first_row; row < nodes_.end_row; ++row) {
      for (int column = nodes_.first_column; column < nodes_.end_column; ++column) {
        if (image_.at(column, row) != inside) continue;
        const double x = (column - nodes_.first_column + 0.5) * side_;
        const double y = (nodes_.end_row - 1 - row + 0.5) * side_;
        cairo_move_to(cairo_, x, y);
        cairo_line_to(cairo_, x, y);
      }
    }
    cairo_stroke(cairo_);
  }

 private:
  cairo_t* cairo_;
  const BitImage& image_;
  const NodeWindow& nodes_;
  int side_;
};

void draw_discs(cairo_t* cairo, const BitImage& image, const NodeWindow& nodes, int side) {
  const Discs discs(cairo, image, nodes, side);
  discs.draw(false, 0.6, 0.5);
  discs.draw(false, 0.45, 1);
  discs.draw(true, 0.8, 0.1);
}

void draw_squares(cairo_t* cairo, const BitImage& image, const NodeWindow& nodes, int side) {
  const auto colour = [&](int row, int column) {
    return image.at(nodes.first_column + column, nodes.first_row + row) ? kInside : kOutside;
  };
  paint_squares(cairo, {nodes.columns(), nodes.rows(), colour}, 0, 0, side);
}

}  // namespace

int node_pixels(const NodeWindow& nodes) {
  return std::clamp(kImageSide / std::max(nodes.columns(), nodes.rows()), 1, kNodePixelsMax);
}

Result<void> draw_image(const FigureLayer& layer, const std::optional<Box2>& window,
                        const std::filesystem::path& path) {
  const auto format = Canvas::format_of(path);
  if (!format) return fail(no_picture(path));
  const SliceGrid& grid = layer.image->grid();
  const auto nodes = nodes_in(window.value_or(area_of(grid)), grid);
  if (!nodes) return fail(nodes.error());
  const int side = node_pixels(*nodes);
  Canvas canvas(*format, nodes->columns() * side, nodes->rows() * side);
  if (side >= kDiscPixels) {
    draw_discs(canvas.cairo(), *layer.image, *nodes, side);
  } else {
    draw_squares(canvas.cairo(), *layer.image, *nodes, side);
  }
  return canvas.write_to(path);
}

}  // namespace slipstick
