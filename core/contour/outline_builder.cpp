#include "core/contour/outline_builder.h"

#include <algorithm>

namespace slipstick {

void OutlineBuilder::add(const ContourSet::Loop& loop, std::span<const std::size_t> kept) {
  // A strict stick test leaves no loop with fewer edges: two edges would lie in disjoint cells.
  SLIPSTICK_CHECK(kept.size() >= 3);
  const LoopView view(contours_, loop);
  Outline::Loop result{{}, loop.depth};
  result.points.reserve(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Run run{kept[i], i + 1 < kept.size() ? kept[i + 1] : kept[0] + loop.count};
    SLIPSTICK_CHECK(run.first < run.last && stabs(view, run));
    max_deviation_ = std::max(max_deviation_, deviation(view, run));
    result.points.push_back(view.vertex(run.first));
  }
  loops_.push_back(std::move(result));
}

void OutlineBuilder::add(const ContourSet::Loop& loop, std::span<const Kept> kept,
                         std::span<const double> bounds) {
  SLIPSTICK_CHECK(kept.size() >= 3);
  const LoopView view(contours_, loop);
  Outline::Loop result{{}, loop.depth};
  result.points.reserve(kept.size());
  for (const Kept& k : kept) result.points.push_back(position(view.stick(k.index), k.place));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const bool last = i + 1 == kept.size();
    const Run run{kept[i].index, last ? kept[0].index + loop.count : kept[i + 1].index};
    const GridPoint end = result.points[last ? 0 : i + 1];
    SLIPSTICK_CHECK(run.first < run.last && stabs(view, run, result.points[i], end));
  }
  for (const double bound : bounds) max_deviation_ = std::max(max_deviation_, bound);
  loops_.push_back(std::move(result));
}

void OutlineBuilder::note_distortion(double distortion) {
  max_distortion_ = std::max(max_distortion_, distortion);
}

Simplified OutlineBuilder::finish() {
  Outline outline(contours_.grid());
  outline.loops_ = std::move(loops_);
  return {std::move(outline), contours_.sticks().size(), max_deviation_ * contours_.grid().unit(),
          max_distortion_};
}

}  // namespace slipstick
