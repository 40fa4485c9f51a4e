#include "host/print_watch.h"

#include <cmath>

#include "core/region/level.h"

namespace slipstick {
namespace {

// Layers sent before the one being laid is finished: what fits into the printer's buffers. Layers
// of a few moves make it more than one.
constexpr std::size_t kLayersUnderWayMax = 64;
// Heights are told to the printer in µm.
constexpr double kSameHeight = 2e-3;

}  // namespace

PrintWatch::PrintWatch(double filament_diameter, double sampling)
    : judge_([this](double z, double) { return contours_at(z); }, {.pixel = sampling / 2}),
      deposit_(filament_diameter, [this](const ExtrudedSegment& bead) { judge_.add(bead); }) {}

void PrintWatch::expect(const SlicedLayer& layer) {
  expected_.push_back({layer.top, polygons_of(layer.contours.outline)});
  if (expected_.size() > kLayersUnderWayMax) expected_.pop_front();
}

Planner::Sink PrintWatch::sink() {
  return [this](const ExecutedMove& move) {
    filament_mm_ += move.to.e - move.from.e;
    deposit_.add(move);
  };
}

std::optional<Contours> PrintWatch::contours_at(double z) const {
  for (const Expected& layer : expected_) {
    if (std::abs(layer.top - z) < kSameHeight) return layer.contours;
  }
  return {};
}

}  // namespace slipstick
