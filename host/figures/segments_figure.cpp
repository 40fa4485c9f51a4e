#include "host/figures/segments_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/contour/vsa_regions.h"
#include "host/figures/view.h"
#include "host/outputs/canvas.h"
#include "host/place_contours.h"

namespace slipstick {
namespace {

constexpr double kPanel = 560, kGap = 14;
constexpr Ink kEdge{0.35, 0.35, 0.35}, kVertex{0.8, 0.2, 0.1};

// Hues a golden angle apart: no two alike, neighbours far from each other.
Ink colour_of(std::size_t region) {
  const double turns = static_cast<double>(region) / std::numbers::phi;
  const double hue = 6 * (turns - std::floor(turns));
  const auto part = [hue](double shift) {
    const double k = std::fmod(hue + shift, 6);
    return 0.85 - 0.75 * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
  };
  return {part(5), part(3), part(1)};
}

std::vector<DrawnLoop> regions_of(const ContourSet& contours, int alpha) {
  std::vector<DrawnLoop> regions;
  for (const ContourSet::Loop& loop : contours.loops()) {
    const DrawnLoop points = loop_in_mm(contours, loop);
    const auto first = vsa_regions(LoopView(contours, loop), alpha);
    for (std::size_t i = 0; i < first.size(); ++i) {
      const std::size_t end = i + 1 < first.size() ? first[i + 1] : first[0] + points.size();
      regions.emplace_back();
      for (std::size_t k = first[i]; k <= end; ++k) {
        regions.back().push_back(points[k % points.size()]);
      }
    }
  }
  return regions;
}

}  // namespace

Segmentation segmentation_of(const PlacedSolid& placed, const FigureLayer& layer,
                             const SlicingSettings& settings) {
  ContourSet contours = trace(*layer.image, settings.ambiguity);
  place_contours(contours, settings.place, *placed.solid, layer.middle);
  const SimplifyOptions options{settings.tolerance, settings.alpha, settings.candidates};
  return {regions_of(contours, settings.alpha), simplify_vsa(contours, options).outline};
}

Result<void> draw_segments(const FigureLayer& layer, const Segmentation& segmentation,
                           const std::optional<Box2>& window, const std::filesystem::path& path) {
  const auto format = Canvas::format_of(path);
  if (!format) return fail(no_picture(path));
  const SliceGrid& grid = layer.image->grid();
  const Box2 area = window.value_or(area_of(grid));
  if (const auto nodes = nodes_in(area, grid); !nodes) return fail(nodes.error());
  Canvas canvas(*format, 2 * kPanel + 3 * kGap, kCaptionHeight + kPanel + kGap);

  const View left(canvas.cairo(), area, {kGap, 0, kPanel});
  for (std::size_t i = 0; i < segmentation.regions.size(); ++i) {
    left.stroke(segmentation.regions[i], Connection::kOpen, colour_of(i), 2.5);
  }
  left.caption(fmt::format("(a) {} regions in the layer", segmentation.regions.size()));

  const View right(canvas.cairo(), area, {kPanel + 2 * kGap, 0, kPanel});
  for (const DrawnLoop& loop : loops_in_mm(segmentation.simplified)) {
    right.stroke(loop, Connection::kClosed, kEdge, 1.2);
    right.dots(loop, kVertex, 4);
  }
  right.caption(fmt::format("(b) {} edges in the layer", segmentation.simplified.edges()));
  return canvas.write_to(path);
}

}  // namespace slipstick
