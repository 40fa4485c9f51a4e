#include "sim/print_judge.h"

#include <algorithm>
#include <cmath>

namespace slipstick {

void PrintJudge::add(const ExtrudedSegment& bead) {
  if (!beads_.empty() && std::abs(bead.z - beads_.front().z) > Deposit::kSameZ) judge();
  beads_.push_back(bead);
}

const PrintVerdict& PrintJudge::finish() {
  if (!beads_.empty()) judge();
  return verdict_;
}

void PrintJudge::judge() {
  const auto contours = contours_of_(beads_.front().z, beads_.front().height);
  if (contours) {
    const LayerVerdict layer = judge_layer(beads_, *contours, options_);
    PrintVerdict& v = verdict_;
    ++v.layers;
    v.components_wrong += layer.components_wrong;
    v.holes_wrong += layer.holes_wrong;
    v.area_error_max = std::max(v.area_error_max, layer.area_error);
    v.area_error_mean += (layer.area_error - v.area_error_mean) / v.layers;
    v.stray_mm2 += layer.stray_mm2;
    const bool wrong = layer.components_wrong + layer.holes_wrong > 0;
    if (wrong && v.wrong_at.size() < kWrongListed) v.wrong_at.push_back(beads_.front().z);
  } else {
    ++verdict_.layers_unknown;
  }
  beads_.clear();
}

}  // namespace slipstick
