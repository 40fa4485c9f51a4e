#include "core/toolpath/plan_layer.h"

#include <iterator>

#include "core/toolpath/infill.h"
#include "core/toolpath/order.h"
#include "core/toolpath/skirt.h"
#include "core/toolpath/walls.h"

namespace slipstick {
namespace {

void append(std::vector<Bead>& to, std::vector<Bead>&& from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

LayerToolpaths plan_layer(const LayerInput& input, const PrintSettings& settings) {
  const LineMeasures lines = measures_of(settings, input.layer, input.height);
  // Deep enough for the innermost level and the nodes just beyond it.
  const double reach = lines.centre(lines.perimeters) + 2 * input.image.grid().width();
  const DistanceField depth(input.image, input.outline, reach);
  std::vector<Bead> beads;
  if (input.layer == 0) append(beads, skirt_beads(input.outline, settings.toolpath));
  append(beads, wall_beads(input.image, depth, lines, settings.slicing));
  append(beads, infill_beads(input, depth, lines, settings));
  return {input.layer, input.top, input.height,
          in_printing_order(std::move(beads), input.outline, settings.toolpath.seam_angle)};
}

}  // namespace slipstick
