#include "sim/print_judge.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace slipstick {

void PrintJudge::keep_ledgers(PrintLedger printed, PrintLedger wanted) {
  SLIPSTICK_CHECK(beads_.empty() && verdict_.layers == 0);
  printed_ = std::move(printed);
  wanted_ = std::move(wanted);
}

void PrintJudge::show_to(Watcher watcher) {
  SLIPSTICK_CHECK(beads_.empty() && verdict_.layers == 0);
  watcher_ = std::move(watcher);
}

void PrintJudge::add(const ExtrudedSegment& bead) {
  if (!beads_.empty() && std::abs(bead.z - beads_.front().z) > Deposit::kSameZ) judge();
  beads_.push_back(bead);
}

const PrintVerdict& PrintJudge::finish() {
  if (!beads_.empty()) judge();
  if (!finished_) look_at_series();
  finished_ = true;
  return verdict_;
}

void PrintJudge::look_at_series() {
  for (const std::size_t i : hollow_layers(traces_)) {
    const LayerTrace& layer = traces_[i];
    ++verdict_.infill_missing;
    list({static_cast<int>(i),
          layer.top,
          {DefectKind::kInfillMissing, layer.cell_place, layer.cell * layer.cell}});
  }
  for (const LayerGap& gap : gaps_in(traces_)) note_gap(gap);
}

/// Each layer of the gap that the solid asks for, at the first of its islands.
void PrintJudge::note_gap(const LayerGap& gap) {
  const LayerTrace& above = traces_[gap.above];
  for (int i = 1; i <= gap.missing; ++i) {
    const double top = above.top - above.height + i * gap.height;
    const auto contours = contours_of_(top, gap.height);
    if (!contours) continue;
    const LayerVerdict nothing = judge_layer({}, *contours, options_);
    if (nothing.defects.empty()) continue;
    ++verdict_.layers_missing;
    list({static_cast<int>(gap.above),
          top,
          {DefectKind::kLayerMissing, nothing.defects.front().place, nothing.solid_mm2}});
  }
}

void PrintJudge::list(const PrintDefect& defect) {
  if (verdict_.defects.size() < PrintVerdict::kDefectsListed) verdict_.defects.push_back(defect);
}

std::optional<Topology> PrintJudge::printed_topology() const {
  return printed_ ? std::optional(printed_->topology()) : std::nullopt;
}

std::optional<Topology> PrintJudge::wanted_topology() const {
  return wanted_ ? std::optional(wanted_->topology()) : std::nullopt;
}

void PrintJudge::judge() {
  const ExtrudedSegment first = beads_.front();
  const auto contours = contours_of_(first.z, first.height);
  const bool on_bed = first.z - first.height < Deposit::kSameZ;
  if (on_bed) below_.reset();
  std::optional<JudgedLayer> judged;
  if (contours) judged = judge_layer_over(below_, beads_, *contours, options_);
  beads_.clear();
  below_.reset();
  if (!judged || (!judged->verdict.touches && verdict_.layers == 0)) {
    ++verdict_.layers_unknown;
    return;
  }
  verdict_.top = first.z;
  verdict_.height_max = std::max(verdict_.height_max, first.height);
  traces_.push_back({first.z, first.height, judged->verdict.void_side, judged->verdict.void_place});
  if (watcher_) watcher_(verdict_.layers, first.z, *judged);
  note(judged->verdict);
  if (printed_) printed_->add(judged->shape);
  if (wanted_) wanted_->add(judged->wanted);
  below_ = std::move(judged->support);
}

void PrintJudge::note(const LayerVerdict& layer) {
  PrintVerdict& v = verdict_;
  for (const Defect& defect : layer.defects) {
    v.rims_bare += defect.kind == DefectKind::kRimBare ? 1 : 0;
    v.in_the_air += defect.kind == DefectKind::kInTheAir ? 1 : 0;
    list({v.layers, v.top, defect});
  }
  ++v.layers;
  v.components_wrong += layer.components_wrong;
  v.holes_wrong += layer.holes_wrong;
  v.area_error_max = std::max(v.area_error_max, layer.area_error);
  v.area_error_mean += (layer.area_error - v.area_error_mean) / v.layers;
  v.stray_mm2 += layer.stray_mm2;
  v.overhang_mm2 += layer.overhang_mm2;
  const bool wrong = layer.components_wrong + layer.holes_wrong > 0;
  if (wrong && v.wrong_at.size() < PrintVerdict::kWrongListed) v.wrong_at.push_back(v.top);
}

}  // namespace slipstick
