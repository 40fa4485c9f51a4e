#include "host/figures/figure_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

Result<int> chosen(const LayerStack& stack, const LayerChoice& choice) {
  if (choice.height) {
    const double z = *choice.height;
    for (int i = 0; i < stack.count(); ++i) {
      if (z >= stack.top(i) - stack.thickness(i) && z <= stack.top(i)) return i;
    }
    return fail(ErrorCode::kInput,
                fmt::format("--height {:g}: no layer is there; the layers reach from 0 to {:g} mm",
                            z, stack.top(stack.count() - 1)));
  }
  const int index = choice.index.value_or(stack.count() / 2);
  if (index >= 0 && index < stack.count()) return index;
  return fail(ErrorCode::kInput,
              fmt::format("--layer {}: there is no such layer; the model has layers 0 to {}", index,
                          stack.count() - 1));
}

/// A node as a number from 0 to `count`: one of the lattice, or one past its end.
int bounded(double node, int count) {
  return static_cast<int>(std::clamp(node, 0.0, static_cast<double>(count)));
}

}  // namespace

Result<FigureLayer> figure_layer(const PlacedSolid& placed, SlicingRequest request,
                                 const LayerChoice& choice) {
  const auto stack = LayerStack::over(placed.bounds.high.z, request.settings.slicing);
  if (!stack) return fail(stack.error());
  const auto index = chosen(*stack, choice);
  if (!index) return fail(index.error());
  request.goal = SliceGoal::kContours;
  request.first_layer = *index;
  request.end_layer = *index + 1;
  request.threads = 1;
  request.settings.slicing.certify = Certification::kOff;
  request.settings.slicing.place = Placement::kMidpoints;
  request.settings.slicing.simplify = Simplification::kNone;
  auto job = SlicingJob::start(placed, request);
  if (!job) return fail(job.error());
  const auto layer = (*job)->next();
  if (!layer) return fail(layer.error());
  SLIPSTICK_CHECK(layer->has_value());
  if (!(*layer)->image->any()) {
    return fail(ErrorCode::kInput,
                fmt::format("layer {} (z = {:g} mm) is empty: no sample is inside; choose another "
                            "by --layer or a finer --sampling",
                            *index, (*layer)->middle));
  }
  return FigureLayer{*index, (*layer)->middle, (*layer)->image};
}

Result<NodeWindow> nodes_in(const Box2& window, const SliceGrid& grid) {
  const double h = grid.width(), x = grid.node_x(0), y = grid.node_y(0);
  const NodeWindow nodes{bounded(std::ceil((window.low.x - x) / h), grid.columns()),
                         bounded(std::floor((window.high.x - x) / h) + 1, grid.columns()),
                         bounded(std::ceil((window.low.y - y) / h), grid.rows()),
                         bounded(std::floor((window.high.y - y) / h) + 1, grid.rows())};
  if (nodes.columns() > 0 && nodes.rows() > 0) return nodes;
  const Box2 area = area_of(grid);
  return fail(ErrorCode::kInput,
              fmt::format("--window {:g},{:g},{:g},{:g}: no sample of the layer is there; the "
                          "layer lies in {:g},{:g},{:g},{:g}",
                          window.low.x, window.low.y, window.high.x, window.high.y, area.low.x,
                          area.low.y, area.high.x, area.high.y));
}

Box2 area_of(const SliceGrid& grid) {
  return {{grid.node_x(0), grid.node_y(0)},
          {grid.node_x(grid.columns() - 1), grid.node_y(grid.rows() - 1)}};
}

Error no_picture(const std::filesystem::path& path) {
  return {ErrorCode::kInput,
          fmt::format("{}: figures are .svg or .png; name the output so", path.string())};
}

}  // namespace slipstick
