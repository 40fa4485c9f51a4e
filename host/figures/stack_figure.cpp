#include "host/figures/stack_figure.h"

#include <cmath>
#include <numbers>
#include <set>

#include "host/figures/figure_layer.h"
#include "host/figures/loops.h"
#include "host/interrupt.h"
#include "host/outputs/canvas.h"
#include "host/progress.h"

namespace slipstick {
namespace {

constexpr double kMargin = 10;
constexpr double kTurn = 30 * std::numbers::pi / 180;  // about the vertical
constexpr double kTilt = 25 * std::numbers::pi / 180;  // of the eye above the horizon

struct DrawnLayer {
  double z = 0;  // mm
  std::vector<DrawnLoop> loops;
};

/// Along parallel rays, y upwards.
Vec2 projected(Vec2 p, double z) {
  const double right = p.x * std::cos(kTurn) - p.y * std::sin(kTurn);
  const double away = p.x * std::sin(kTurn) + p.y * std::cos(kTurn);
  return {right, z * std::cos(kTilt) + away * std::sin(kTilt)};
}

std::set<int> chosen_of(const SlicingJob& job) {
  const int count = job.end_layer() - job.first_layer();
  const int drawn = std::min(count, kStackLayersMax);
  std::set<int> chosen;
  for (int i = 0; i < drawn; ++i) {
    chosen.insert(job.first_layer() + (2 * i + 1) * count / (2 * drawn));
  }
  return chosen;
}

Result<std::vector<DrawnLayer>> collect(SlicingJob& job) {
  const std::set<int> chosen = chosen_of(job);
  Progress progress("slicing", job.end_layer() - job.first_layer());
  std::vector<DrawnLayer> layers;
  while (true) {
    if (Interrupt::requested()) {
      return fail(ErrorCode::kCancelled, "interrupted; nothing was written");
    }
    const auto layer = job.next();
    if (!layer) return fail(layer.error());
    if (!*layer) return layers;
    progress.show(job.totals().layers, (*layer)->top);
    const Outline& outline = (*layer)->contours.outline;
    if (!chosen.contains((*layer)->index) || outline.loops().empty()) continue;
    layers.push_back({(*layer)->middle, loops_in_mm(outline)});
    for (DrawnLoop& loop : layers.back().loops) {
      for (Vec2& p : loop) p = projected(p, layers.back().z);
    }
  }
}

void draw(cairo_t* cairo, const DrawnLayer& layer, double share, double pixel) {
  for (const DrawnLoop& loop : layer.loops) {
    cairo_new_sub_path(cairo);
    for (const Vec2 p : loop) cairo_line_to(cairo, p.x, p.y);
    cairo_close_path(cairo);
  }
  const double light = 0.55 + 0.4 * share;
  cairo_set_source_rgb(cairo, light * 0.86, light * 0.93, light);
  cairo_fill_preserve(cairo);
  cairo_set_source_rgb(cairo, light * 0.3, light * 0.38, light * 0.5);
  cairo_set_line_width(cairo, 0.6 * pixel);
  cairo_stroke(cairo);
}

}  // namespace

Result<void> draw_stack(SlicingJob& job, int side, const std::filesystem::path& path) {
  const auto format = Canvas::format_of(path);
  if (!format) return fail(no_picture(path));
  const auto layers = collect(job);
  if (!layers) return fail(layers.error());
  Box2 box;
  for (const DrawnLayer& layer : *layers) {
    for (const DrawnLoop& loop : layer.loops) {
      for (const Vec2 p : loop) box = box.with(p);
    }
  }
  if (box.empty()) {
    return fail(ErrorCode::kInput,
                "nothing to draw: no sample of any layer is inside; give a finer --sampling");
  }
  const Vec2 size = box.high - box.low;
  const double scale = side / std::max(size.x, size.y);
  Canvas canvas(*format, std::ceil(size.x * scale + 2 * kMargin),
                std::ceil(size.y * scale + 2 * kMargin));
  cairo_t* const cairo = canvas.cairo();
  cairo_translate(cairo, kMargin, kMargin + size.y * scale);
  cairo_scale(cairo, scale, -scale);
  cairo_translate(cairo, -box.low.x, -box.low.y);
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  const double lowest = layers->front().z, span = layers->back().z - lowest;
  for (const DrawnLayer& layer : *layers) {
    draw(cairo, layer, span > 0 ? (layer.z - lowest) / span : 1, 1 / scale);
  }
  return canvas.write_to(path);
}

}  // namespace slipstick
