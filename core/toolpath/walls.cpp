#include "core/toolpath/walls.h"

#include <utility>

#include "core/base/box.h"
#include "core/region/level.h"
#include "core/toolpath/flow.h"
#include "core/toolpath/thin_beads.h"

namespace slipstick {
namespace {

// A ring that is shorter than this many line widths has no middle to leave free.
constexpr double kRingMin = 1;

Bead ring_bead(std::vector<Vec2>&& polygon, double width, Role role) {
  Box2 extent;
  double around = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    extent = extent.with(polygon[i]);
    around += length(polygon[i + 1 < polygon.size() ? i + 1 : 0] - polygon[i]);
  }
  if (around < kRingMin * width) return dot(0.5 * (extent.low + extent.high), width, role);
  return {std::move(polygon), {width}, role, true};
}

struct Ring {
  double depth;
  Role role;
};

std::vector<Bead> ring_beads(const BitImage& inside, const DistanceField& depth, const Ring& ring,
                             const LineMeasures& lines, Ambiguity ambiguity) {
  std::vector<Bead> beads;
  const Outline rings = level_outline(inside, depth, ring.depth, lines.tolerance, ambiguity);
  for (auto& polygon : polygons_of(rings)) {
    beads.push_back(ring_bead(std::move(polygon), lines.width, ring.role));
  }
  return beads;
}

}  // namespace

LineMeasures measures_of(const PrintSettings& settings, int layer, double height) {
  const ToolpathSettings& t = settings.toolpath;
  const double width = layer == 0 ? t.first_layer_line_width : t.line_width;
  return {width, bead_spacing(width, height), t.perimeters, t.infill_overlap,
          settings.slicing.tolerance / 2};
}

std::vector<Bead> wall_beads(const BitImage& image, const DistanceField& depth,
                             const LineMeasures& lines, const SlicingSettings& slicing) {
  std::vector<Bead> beads;
  BitImage region = image;
  for (int k = 0; k <= lines.perimeters && region.any(); ++k) {
    const bool is_infill = k == lines.perimeters;
    const double level = is_infill ? lines.infill_edge() : lines.centre(k);
    const BitImage full = depth.at_least(level);
    if (!is_infill) {
      const Role role = k == 0 ? Role::kOuterPerimeter : Role::kInnerPerimeter;
      const auto rings = ring_beads(full, depth, {level, role}, lines, slicing.ambiguity);
      beads.insert(beads.end(), rings.begin(), rings.end());
    }
    const auto thin =
        thin_beads({region, full, depth, lines.edge(k), lines.width, slicing.ambiguity});
    beads.insert(beads.end(), thin.begin(), thin.end());
    if (!is_infill) region = depth.at_least(lines.edge(k + 1));
  }
  return beads;
}

}  // namespace slipstick
