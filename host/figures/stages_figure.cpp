#include "host/figures/stages_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contour/place_smooth.h"
#include "core/contour/trace.h"
#include "host/figures/loops.h"
#include "host/figures/view.h"
#include "host/outputs/canvas.h"
#include "host/place_contours.h"

namespace slipstick {
namespace {

constexpr double kPanel = 300, kGap = 10;
constexpr std::size_t kReach = 8;  // vertices each way over which a contour's turn is measured
constexpr Ink kNode{0.25, 0.25, 0.25}, kHollow{0.65, 0.65, 0.65}, kWhite{1, 1, 1},
    kStick{0.45, 0.65, 0.9}, kContour{0.8, 0.2, 0.1};

struct Stage {
  std::string caption;
  std::vector<DrawnLoop> loops;
};

std::array<Stage, 5> stages_of(const ContourSet& traced, const Solid& solid, double z) {
  const auto placed = [&](Placement placement) {
    ContourSet contours = traced;
    place_contours(contours, placement, solid, z);
    return loops_in_mm(contours);
  };
  return {{{"(a) midpoints", placed(Placement::kMidpoints)},
           {"(b) sliding on sticks", placed(Placement::kSliding)},
           {"(c) projection onto sticks", placed(Placement::kProjection)},
           {"(d) ordinary Laplacian", free_loops_in_mm(traced)},
           {"(e) roots of f", placed(Placement::kRoots)}}};
}

/// What lies below the contours in each panel, in mm.
struct Ground {
  std::vector<Vec2> inside, outside;  // nodes
  std::vector<std::array<Vec2, 2>> sticks;
};

Ground ground_of(const BitImage& image, const ContourSet& traced, const NodeWindow& nodes) {
  const SliceGrid& grid = image.grid();
  Ground ground;
  for (int row = nodes.first_row; row < nodes.end_row; ++row) {
    for (int column = nodes.first_column; column < nodes.end_column; ++column) {
      auto& list = image.at(column, row) ? ground.inside : ground.outside;
      list.push_back({grid.node_x(column), grid.node_y(row)});
    }
  }
  const auto mm = [&](GridPoint p) { return Vec2{grid.x_of(p.x), grid.y_of(p.y)}; };
  for (const Stick stick : traced.sticks()) {
    const bool seen = stick.column >= nodes.first_column && stick.column < nodes.end_column &&
                      stick.row >= nodes.first_row && stick.row < nodes.end_row;
    if (!seen) continue;
    ground.sticks.push_back(
        {mm(along(stick, 0)), mm(along(stick, static_cast<int>(SliceGrid::kUnitsPerCell)))});
  }
  return ground;
}

void draw_stage(const View& view, const Stage& stage, const Ground& ground, double h) {
  const double node = std::clamp(0.3 * h * view.scale(), 1.0, 6.0);
  for (const auto& stick : ground.sticks) view.stroke(stick, Connection::kOpen, kStick, 1);
  view.dots(ground.outside, kHollow, node);
  view.dots(ground.outside, kWhite, 0.6 * node);
  view.dots(ground.inside, kNode, node);
  for (const DrawnLoop& loop : stage.loops) {
    view.stroke(loop, Connection::kClosed, kContour, 1.8);
  }
  view.border();
  view.caption(stage.caption);
}

// The angle between the ways from `kReach` vertices before to here, and from here to as many after.
double turn_at(const DrawnLoop& loop, std::size_t i) {
  const std::size_t n = loop.size(), reach = std::min(kReach, n / 3);
  const Vec2 in = loop[i] - loop[(i + n - reach) % n];
  const Vec2 out = loop[(i + reach) % n] - loop[i];
  return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

Result<NodeWindow> checked(const Box2& window, const SliceGrid& grid) {
  auto nodes = nodes_in(window, grid);
  if (!nodes) return nodes;
  const int widest = std::max(nodes->columns(), nodes->rows());
  if (widest <= kStageNodesMax) return nodes;
  return fail(ErrorCode::kInput,
              fmt::format("--window is {} nodes wide, of which nothing could be seen; give at most "
                          "{}, {:g} mm",
                          widest, kStageNodesMax, kStageNodesMax * grid.width()));
}

}  // namespace

Box2 most_curved_window(const BitImage& image, Ambiguity ambiguity) {
  ContourSet contours = trace(image, ambiguity);
  SLIPSTICK_CHECK(!contours.loops().empty());
  place_sliding(contours);
  const auto longest = std::ranges::max_element(contours.loops(), {}, &ContourSet::Loop::count);
  const DrawnLoop loop = loop_in_mm(contours, *longest);
  std::size_t at = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    if (turn_at(loop, i) > turn_at(loop, at)) at = i;
  }
  const double half = 0.5 * kStageNodes * image.grid().width();
  return {loop[at] - Vec2{half, half}, loop[at] + Vec2{half, half}};
}

Result<void> draw_stages(const PlacedSolid& placed, const FigureLayer& layer, Ambiguity ambiguity,
                         const std::optional<Box2>& window, const std::filesystem::path& path) {
  const auto format = Canvas::format_of(path);
  if (!format) return fail(no_picture(path));
  const Box2 area = window ? *window : most_curved_window(*layer.image, ambiguity);
  const auto nodes = checked(area, layer.image->grid());
  if (!nodes) return fail(nodes.error());
  const ContourSet traced = trace(*layer.image, ambiguity);
  const Ground ground = ground_of(*layer.image, traced, *nodes);
  if (ground.sticks.empty()) {
    return fail(ErrorCode::kInput,
                fmt::format("--window {:g},{:g},{:g},{:g}: no contour passes there; leave it out "
                            "to see where one does",
                            area.low.x, area.low.y, area.high.x, area.high.y));
  }
  const auto stages = stages_of(traced, *placed.solid, layer.middle);
  const auto count = static_cast<double>(stages.size());
  Canvas canvas(*format, count * (kPanel + kGap) + kGap, kCaptionHeight + kPanel + kGap);
  double x = kGap;
  for (const Stage& stage : stages) {
    draw_stage(View(canvas.cairo(), area, {x, 0, kPanel}), stage, ground,
               layer.image->grid().width());
    x += kPanel + kGap;
  }
  return canvas.write_to(path);
}

}  // namespace slipstick
