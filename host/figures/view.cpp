#include "host/figures/view.h"

#include <algorithm>

namespace slipstick {
namespace {

constexpr double kText = 13;
constexpr Ink kBlack{0.1, 0.1, 0.1}, kGrey{0.7, 0.7, 0.7};

void set_source(cairo_t* cairo, Ink ink) {
  cairo_set_source_rgb(cairo, ink.red, ink.green, ink.blue);
}

}  // namespace

View::View(cairo_t* cairo, const Box2& area, const Frame& frame)
    : cairo_(cairo),
      frame_{frame.x, frame.y + kCaptionHeight, frame.size},
      centre_(0.5 * (area.low + area.high)) {
  const Vec2 size = area.high - area.low;
  const double side = std::max(size.x, size.y);
  scale_ = frame.size / side;
  const Vec2 half{side / 2, side / 2};
  seen_ = {centre_ - half, centre_ + half};
}

void View::caption(const std::string& words) const {
  cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, kText);
  set_source(cairo_, kBlack);
  cairo_move_to(cairo_, frame_.x, frame_.y - kText / 2);
  cairo_show_text(cairo_, words.c_str());
  cairo_new_path(cairo_);  // Text leaves a point behind.
}

void View::border() const {
  set_source(cairo_, kGrey);
  cairo_set_line_width(cairo_, 1);
  cairo_rectangle(cairo_, frame_.x, frame_.y, frame_.size, frame_.size);
  cairo_stroke(cairo_);
}

void View::stroke(std::span<const Vec2> points, Connection connection, Ink ink,
                  double width) const {
  const std::size_t edges = connection == Connection::kClosed ? points.size() : points.size() - 1;
  clip();
  set_source(cairo_, ink);
  cairo_set_line_width(cairo_, width);
  bool joined = false;
  for (std::size_t i = 0; i < edges; ++i) {
    const Vec2 a = points[i], b = points[i + 1 < points.size() ? i + 1 : 0];
    if (seen(a, b)) {
      const Vec2 from = at(a), to = at(b);
      if (!joined) cairo_move_to(cairo_, from.x, from.y);
      cairo_line_to(cairo_, to.x, to.y);
    }
    joined = seen(a, b);
  }
  cairo_stroke(cairo_);
  cairo_restore(cairo_);
}

void View::dots(std::span<const Vec2> points, Ink ink, double diameter) const {
  clip();
  set_source(cairo_, ink);
  cairo_set_line_width(cairo_, diameter);
  for (const Vec2 p : points) {
    if (!seen(p, p)) continue;
    const Vec2 centre = at(p);
    cairo_move_to(cairo_, centre.x, centre.y);
    cairo_line_to(cairo_, centre.x, centre.y);  // round caps make a disc of it
  }
  cairo_stroke(cairo_);
  cairo_restore(cairo_);
}

Vec2 View::at(Vec2 mm) const {
  const Vec2 off = scale_ * (mm - centre_);
  return {frame_.x + frame_.size / 2 + off.x, frame_.y + frame_.size / 2 - off.y};
}

bool View::seen(Vec2 a, Vec2 b) const {
  return std::min(a.x, b.x) <= seen_.high.x && std::max(a.x, b.x) >= seen_.low.x &&
         std::min(a.y, b.y) <= seen_.high.y && std::max(a.y, b.y) >= seen_.low.y;
}

// To be followed by cairo_restore.
void View::clip() const {
  cairo_save(cairo_);
  cairo_rectangle(cairo_, frame_.x, frame_.y, frame_.size, frame_.size);
  cairo_clip(cairo_);
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
}

}  // namespace slipstick
