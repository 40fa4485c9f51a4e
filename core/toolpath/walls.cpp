#include "core/toolpath/walls.h"

#include "core/region/level.h"
#include "core/toolpath/flow.h"
#include "core/toolpath/thin_beads.h"

namespace slipstick {
namespace {

void add_rings(const BitImage& inside, const DistanceField& depth, double level, Role role,
               const LineMeasures& lines, const SlicingSettings& slicing,
               std::vector<Bead>& beads) {
  const Outline rings = level_outline(inside, depth, level, lines.tolerance, slicing.ambiguity);
  for (auto& polygon : polygons_of(rings)) {
    beads.push_back({std::move(polygon), {lines.width}, role, true});
  }
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
      add_rings(full, depth, level, role, lines, slicing, beads);
    }
    const auto thin =
        thin_beads({region, full, depth, lines.edge(k), lines.width, slicing.ambiguity});
    beads.insert(beads.end(), thin.begin(), thin.end());
    if (!is_infill) region = depth.at_least(lines.edge(k + 1));
  }
  return beads;
}

}  // namespace slipstick
