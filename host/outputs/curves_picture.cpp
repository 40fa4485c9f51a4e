#include "host/outputs/curves_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>

#include "host/outputs/canvas.h"
#include "host/outputs/tick.h"

namespace slipstick {
namespace {

using Sample = Curves::Sample;
using Value = std::function<double(const Sample&)>;

constexpr double kWidth = 1000, kHeight = 640, kLeft = 60, kRight = 20, kGap = 50, kTop = 30;
constexpr double kPanel = (kHeight - kTop - 2 * kGap) / 2;
constexpr double kText = 12;
constexpr int kTicks = 6;  // at most about so many an axis

struct Colour {
  double red, green, blue;
};
constexpr Colour kBlack{0, 0, 0}, kGrey{0.8, 0.8, 0.8}, kRed{0.8, 0.2, 0.2}, kBlue{0.2, 0.4, 0.8};

enum class Stroke { kSolid, kDashed };

/// One of the two diagrams: time to the right, `most` at its top.
class Panel {
 public:
  Panel(cairo_t* cairo, double top, double seconds, double most)
      : cairo_(cairo), top_(top), seconds_(seconds), most_(most) {}

  void axes(const std::string& title) const {
    cairo_set_line_width(cairo_, 1);
    const double step = tick_step(most_, kTicks);
    for (double v = 0; v <= most_; v += step) {
      line(kLeft, y(v), kWidth - kRight, y(v), kGrey);
      text(8, y(v) + kText / 3, fmt::format("{:g}", v));
    }
    const double seconds = tick_step(seconds_, kTicks);
    for (double t = 0; t <= seconds_; t += seconds) {
      line(x(t), top_, x(t), top_ + kPanel, kGrey);
      text(x(t) - kText / 2, top_ + kPanel + 1.5 * kText, fmt::format("{:g} s", t));
    }
    text(kLeft, top_ - kText / 2, title);
  }

  void curve(const Curves& curves, const Value& value, Colour colour, Stroke stroke) const {
    const double dash = 4;
    cairo_set_source_rgb(cairo_, colour.red, colour.green, colour.blue);
    cairo_set_dash(cairo_, &dash, stroke == Stroke::kDashed ? 1 : 0, 0);
    cairo_set_line_width(cairo_, 1.5);
    cairo_new_path(cairo_);  // Text leaves a point behind.
    double middle = curves.span_seconds() / 2;
    for (const Sample& sample : curves.samples()) {
      cairo_line_to(cairo_, x(middle), y(value(sample)));
      middle += curves.span_seconds();
    }
    cairo_stroke(cairo_);
    cairo_set_dash(cairo_, nullptr, 0, 0);
  }

 private:
  [[nodiscard]] double x(double t) const {
    return kLeft + t / seconds_ * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] double y(double v) const { return top_ + kPanel * (1 - v / most_); }

  void line(double x0, double y0, double x1, double y1, Colour colour) const {
    cairo_set_source_rgb(cairo_, colour.red, colour.green, colour.blue);
    cairo_move_to(cairo_, x0, y0);
    cairo_line_to(cairo_, x1, y1);
    cairo_stroke(cairo_);
  }

  void text(double x0, double y0, const std::string& words) const {
    cairo_set_source_rgb(cairo_, 0, 0, 0);
    cairo_set_font_size(cairo_, kText);
    cairo_move_to(cairo_, x0, y0);
    cairo_show_text(cairo_, words.c_str());
  }

  cairo_t* cairo_;
  double top_;
  double seconds_;
  double most_;
};

double most_of(const Curves& curves, const Value& value) {
  double most = 1;
  for (const Sample& sample : curves.samples()) most = std::max(most, value(sample));
  return 1.05 * most;
}

}  // namespace

Result<void> draw_curves(const Curves& curves, const std::filesystem::path& path) {
  const auto format = Canvas::format_of(path);
  if (!format) {
    return fail(ErrorCode::kInput, fmt::format("{}: curves are .svg or .png", path.string()));
  }
  if (curves.samples().empty()) {
    return fail(ErrorCode::kInput, fmt::format("{}: there is nothing to draw", path.string()));
  }
  Canvas canvas(*format, kWidth, kHeight);
  const double span = curves.span_seconds();
  const double seconds = span * static_cast<double>(curves.samples().size());
  const auto hottest = [](const Sample& s) {
    return std::max({s.nozzle, s.nozzle_target, s.bed, s.bed_target});
  };
  const Panel heat(canvas.cairo(), kTop, seconds, most_of(curves, hottest));
  heat.axes("°C: nozzle red, bed blue, targets dashed");
  heat.curve(
      curves, [](const Sample& s) { return s.nozzle_target; }, kRed, Stroke::kDashed);
  heat.curve(
      curves, [](const Sample& s) { return s.bed_target; }, kBlue, Stroke::kDashed);
  heat.curve(
      curves, [](const Sample& s) { return s.nozzle; }, kRed, Stroke::kSolid);
  heat.curve(
      curves, [](const Sample& s) { return s.bed; }, kBlue, Stroke::kSolid);

  const auto fastest = [](const Sample& s) { return s.speed_max; };
  const Panel speed(canvas.cairo(), kTop + kPanel + kGap, seconds, most_of(curves, fastest));
  speed.axes("mm/s: mean black, fastest move dashed");
  speed.curve(curves, fastest, kBlack, Stroke::kDashed);
  speed.curve(
      curves, [span](const Sample& s) { return s.way / span; }, kBlack, Stroke::kSolid);
  return canvas.write_to(path);
}

}  // namespace slipstick
