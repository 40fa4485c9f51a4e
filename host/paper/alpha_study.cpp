#include "host/paper/alpha_study.h"

#include <fmt/format.h>

#include "host/outputs/canvas.h"
#include "host/outputs/line_chart.h"
#include "host/paper/paper_tables.h"
#include "host/paper/slice_through.h"
#include "host/stopwatch.h"

namespace slipstick {
namespace {

constexpr double kChartWidth = 320, kChartHeight = 260, kTitleHeight = 34, kTitleText = 14;
constexpr const char* kAlpha = "clustering ratio α";

void write_title(cairo_t* cairo, const std::string& title) {
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, kTitleText);
  cairo_set_source_rgb(cairo, 0, 0, 0);
  cairo_move_to(cairo, 8, kTitleHeight - kTitleText / 2);
  cairo_show_text(cairo, title.c_str());
}

}  // namespace

Result<std::vector<AlphaResult>> alpha_study(const PlacedSolid& placed, SlicingRequest request,
                                             std::span<const int> alphas) {
  request.settings.slicing.simplify = Simplification::kVsa;
  std::vector<AlphaResult> results;
  for (const int alpha : alphas) {
    request.settings.slicing.alpha = alpha;
    Stopwatch watch;
    const auto totals = slice_through(placed, request);
    if (!totals) return fail(totals.error());
    results.push_back({alpha, totals->max_regional_distortion, totals->edges_after, watch.lap()});
  }
  return results;
}

Result<void> draw_alpha_study(std::span<const AlphaResult> results, const std::string& title,
                              const std::filesystem::path& path) {
  const auto format = Canvas::format_of(path);
  if (!format) {
    return fail(ErrorCode::kInput, fmt::format("{}: charts are .svg or .png", path.string()));
  }
  if (results.empty()) {
    return fail(ErrorCode::kInput, fmt::format("{}: there is nothing to draw", path.string()));
  }
  LineChart distortion{"largest regional distortion", "in³", kAlpha, {}};
  LineChart edges{"edges after simplification", "", kAlpha, {}};
  LineChart seconds{"time", "s", kAlpha, {}};
  for (const AlphaResult& result : results) {
    const auto alpha = static_cast<double>(result.alpha);
    distortion.points.push_back({alpha, result.distortion / kCubicInch});
    edges.points.push_back({alpha, static_cast<double>(result.edges)});
    seconds.points.push_back({alpha, result.seconds});
  }
  Canvas canvas(*format, 3 * kChartWidth, kTitleHeight + kChartHeight);
  write_title(canvas.cairo(), title);
  double x = 0;
  for (const LineChart* chart : {&distortion, &edges, &seconds}) {
    draw_line_chart(canvas.cairo(), *chart, {x, kTitleHeight, kChartWidth, kChartHeight});
    x += kChartWidth;
  }
  return canvas.write_to(path);
}

}  // namespace slipstick
