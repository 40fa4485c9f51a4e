#include "host/outputs/layer_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace slipstick {
namespace {

constexpr double kCaption = 18;  // height kept free above the drawing
constexpr double kMargin = 6;

struct Colour {
  double red, green, blue;
};

Colour colour_of(Role role) {
  switch (role) {
    case Role::kSkirt:
      return {0.60, 0.60, 0.60};
    case Role::kOuterPerimeter:
      return {0.85, 0.37, 0.01};
    case Role::kInnerPerimeter:
      return {0.96, 0.68, 0.30};
    case Role::kThinBead:
      return {0.77, 0.11, 0.49};
    case Role::kSkin:
      return {0.18, 0.47, 0.70};
    case Role::kInfill:
      return {0.30, 0.68, 0.55};
  }
  return {0, 0, 0};
}

void path_of(cairo_t* cairo, const std::vector<Vec2>& points) {
  cairo_move_to(cairo, points[0].x, points[0].y);
  for (std::size_t i = 1; i < points.size(); ++i) cairo_line_to(cairo, points[i].x, points[i].y);
}

void fill_outline(cairo_t* cairo, const Outline& outline) {
  for (const Outline::Loop& loop : outline.loops()) {
    std::vector<Vec2> points;
    for (const GridPoint p : loop.points) points.push_back(outline.mm(p));
    path_of(cairo, points);
    cairo_close_path(cairo);
  }
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_set_source_rgb(cairo, 0.93, 0.93, 0.90);
  cairo_fill_preserve(cairo);
  cairo_set_source_rgb(cairo, 0.2, 0.2, 0.2);
  cairo_set_line_width(cairo, 0.03);
  cairo_stroke(cairo);
}

void stroke_bead(cairo_t* cairo, const Bead& bead) {
  const Colour c = colour_of(bead.role);
  cairo_set_source_rgba(cairo, c.red, c.green, c.blue, 0.8);
  if (bead.widths.size() == 1) {
    path_of(cairo, bead.points);
    if (bead.closed) cairo_close_path(cairo);
    cairo_set_line_width(cairo, bead.widths[0] * 0.9);
    return cairo_stroke(cairo);
  }
  for (std::size_t i = 0; i < bead.widths.size(); ++i) {
    const Vec2 a = bead.points[i], b = bead.points[(i + 1) % bead.points.size()];
    cairo_move_to(cairo, a.x, a.y);
    cairo_line_to(cairo, b.x, b.y);
    cairo_set_line_width(cairo, bead.widths[i] * 0.9);
    cairo_stroke(cairo);
  }
}

void caption(cairo_t* cairo, const LayerPicture& picture, const Frame& frame) {
  const std::string text = fmt::format("layer {}  z = {:.3f} mm", picture.index, picture.middle);
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, 11);
  cairo_set_source_rgb(cairo, 0.1, 0.1, 0.1);
  cairo_move_to(cairo, frame.x + kMargin, frame.y + kCaption - 5);
  cairo_show_text(cairo, text.c_str());
}

}  // namespace

void draw_layer(cairo_t* cairo, const LayerPicture& picture, const Box2& area, const Frame& frame) {
  caption(cairo, picture, frame);
  const double room = frame.size - kCaption - kMargin;
  const Vec2 size = area.high - area.low;
  const double scale = room / std::max({size.x, size.y, 1e-3});
  cairo_save(cairo);
  cairo_rectangle(cairo, frame.x, frame.y + kCaption, frame.size, frame.size - kCaption);
  cairo_clip(cairo);
  cairo_translate(cairo, frame.x + frame.size / 2, frame.y + kCaption + room / 2);
  cairo_scale(cairo, scale, -scale);
  cairo_translate(cairo, -(area.low.x + area.high.x) / 2, -(area.low.y + area.high.y) / 2);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  fill_outline(cairo, picture.outline);
  for (const Bead& bead : picture.beads) stroke_bead(cairo, bead);
  cairo_restore(cairo);
}

}  // namespace slipstick
