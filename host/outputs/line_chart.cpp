#include "host/outputs/line_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/outputs/tick.h"

namespace slipstick {
namespace {

constexpr double kLeft = 46, kRight = 12, kTop = 26, kBottom = 40;  // room for words
constexpr double kText = 12;
constexpr double kMark = 3.5;  // radius of a point
constexpr int kTicks = 6;

/// The largest value of an axis from 0, with a little room.
double most_of(const std::vector<Vec2>& points, double Vec2::*part) {
  double most = 0;
  for (const Vec2& p : points) most = std::max(most, p.*part);
  return most > 0 ? 1.06 * most : 1;
}

class Plot {
 public:
  Plot(cairo_t* cairo, const LineChart& chart, const ChartFrame& frame)
      : cairo_(cairo),
        chart_(chart),
        left_(frame.x + kLeft),
        low_(frame.y + frame.height - kBottom),
        width_(frame.width - kLeft - kRight),
        height_(frame.height - kTop - kBottom),
        most_x_(most_of(chart.points, &Vec2::x)),
        most_y_(most_of(chart.points, &Vec2::y)) {
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, kText);
  }

  void axes() const {
    // Thousands and thousandths are told once, in the title.
    const int power = 3 * static_cast<int>(std::floor(std::log10(most_y_) / 3));
    const double step = tick_step(most_y_, kTicks);
    for (int i = 0; i * step <= most_y_; ++i) {
      line({left_, y(i * step)}, {left_ + width_, y(i * step)}, i == 0 ? 0 : 0.85);
      const std::string words = fmt::format("{:.4g}", i * step / std::pow(10, power));
      text({left_ - 6 - width_of(words), y(i * step) + kText / 3}, words);
    }
    const double across = tick_step(most_x_, kTicks);
    for (int i = 0; i * across <= most_x_; ++i) {
      line({x(i * across), low_}, {x(i * across), low_ + 4}, 0);
      const std::string words = fmt::format("{:g}", i * across);
      text({x(i * across) - width_of(words) / 2, low_ + 5 + kText}, words);
    }
    line({left_, low_}, {left_, low_ - height_}, 0);
    text({left_ + (width_ - width_of(chart_.over)) / 2, low_ + 2.75 * kText}, chart_.over);
    text({left_ - kLeft + 8, low_ - height_ - kText}, title(power));
  }

  void curve() const {
    cairo_new_path(cairo_);  // Text leaves a point behind.
    cairo_set_source_rgb(cairo_, 0.1, 0.3, 0.6);
    cairo_set_line_width(cairo_, 1.6);
    for (const Vec2& p : chart_.points) cairo_line_to(cairo_, x(p.x), y(p.y));
    cairo_stroke(cairo_);
    for (const Vec2& p : chart_.points) {
      cairo_arc(cairo_, x(p.x), y(p.y), kMark, 0, 2 * std::numbers::pi);
      cairo_fill(cairo_);
    }
  }

 private:
  [[nodiscard]] double x(double v) const { return left_ + v / most_x_ * width_; }
  [[nodiscard]] double y(double v) const { return low_ - v / most_y_ * height_; }

  [[nodiscard]] std::string title(int power) const {
    const std::string times = power == 0 ? "" : fmt::format("1e{}", power);
    const std::string gap = times.empty() || chart_.unit.empty() ? "" : " ";
    const std::string unit = times + gap + chart_.unit;
    return unit.empty() ? chart_.quantity : fmt::format("{} [{}]", chart_.quantity, unit);
  }

  [[nodiscard]] double width_of(const std::string& words) const {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, words.c_str(), &extents);
    return extents.x_advance;
  }

  void line(Vec2 a, Vec2 b, double grey) const {
    cairo_set_source_rgb(cairo_, grey, grey, grey);
    cairo_set_line_width(cairo_, 0.8);
    cairo_move_to(cairo_, a.x, a.y);
    cairo_line_to(cairo_, b.x, b.y);
    cairo_stroke(cairo_);
  }

  void text(Vec2 at, const std::string& words) const {
    cairo_set_source_rgb(cairo_, 0, 0, 0);
    cairo_move_to(cairo_, at.x, at.y);
    cairo_show_text(cairo_, words.c_str());
  }

  cairo_t* cairo_;
  const LineChart& chart_;
  double left_;
  double low_;
  double width_;
  double height_;
  double most_x_;
  double most_y_;
};

}  // namespace

void draw_line_chart(cairo_t* cairo, const LineChart& chart, const ChartFrame& frame) {
  const Plot plot(cairo, chart, frame);
  plot.axes();
  plot.curve();
}

}  // namespace slipstick
