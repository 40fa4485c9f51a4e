#include "host/slicing_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace slipstick {
namespace {

// Layers begun beyond the one that is being handed over: one for each worker and two in reserve.
constexpr int kReserve = 2;

int thread_count(int wanted) {
  if (wanted > 0) return wanted;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

Result<std::unique_ptr<SlicingJob>> SlicingJob::start(const PlacedSolid& placed,
                                                      const SlicingRequest& request) {
  const Box3& b = placed.bounds;
  const SlicingSettings& slicing = request.settings.slicing;
  if (slicing.certify == Certification::kStrict && !placed.solid->field()) {
    return fail(ErrorCode::kInput,
                "nothing can be certified of a solid that is not a formula; use --certify report");
  }
  if (slicing.certify == Certification::kStrict && slicing.regularize > 0) {
    return fail(ErrorCode::kInput,
                "a regularized solid is no longer the formula that could be certified; use "
                "--certify report");
  }
  // Room for what grows before it shrinks back.
  const double room = slicing.regularize;
  const auto grid =
      SliceGrid::over({{b.low.x - room, b.low.y - room}, {b.high.x + room, b.high.y + room}},
                      LayerStack::aligned_sampling(slicing));
  if (!grid) return fail(grid.error());
  const auto stack = LayerStack::over(b.high.z, slicing);
  if (!stack) return fail(stack.error());
  if (request.first_layer < 0 || request.first_layer >= stack->count() ||
      request.end_layer.value_or(stack->count()) <= request.first_layer) {
    return fail(ErrorCode::kInput,
                fmt::format("no such layers; the model has layers 0 to {}", stack->count() - 1));
  }
  return std::unique_ptr<SlicingJob>(new SlicingJob(placed, *grid, *stack, request));
}

SlicingJob::SlicingJob(const PlacedSolid& placed, const SliceGrid& grid, const LayerStack& stack,
                       const SlicingRequest& request)
    : grid_(grid),
      first_(request.first_layer),
      end_(std::min(request.end_layer.value_or(stack.count()), stack.count())),
      threads_(thread_count(request.threads)),
      certification_(request.settings.slicing.certify),
      timeline_(request.timeline ? request.timeline
                                 : std::make_shared<SettingsTimeline>(request.settings)),
      slicer_(placed, grid, stack, *timeline_, request.goal),
      ledger_(request.settings.slicing.ambiguity) {
  timeline_->end_at(end_);
  crew_ = std::make_unique<OrderedCrew<SlicedLayer>>(
      OrderedCrew<SlicedLayer>::Options{first_, end_, threads_, threads_ + kReserve},
      [this](int layer) { return slicer_.slice(layer); });
}

Result<std::optional<SlicedLayer>> SlicingJob::next() {
  auto layer = crew_->next();
  if (layer && *layer) {
    add(**layer);
    slicer_.finished_below((*layer)->index + 1);
    const auto& certificate = (*layer)->certificate;
    if (certification_ == Certification::kStrict && certificate && !certificate->proved()) {
      return fail(ErrorCode::kInput, "not certified: " + unproved_text(**layer));
    }
  }
  return layer;
}

void SlicingJob::add(const SlicedLayer& layer) {
  ++totals_.layers;
  ledger_.add(*layer.image);
  totals_.edges_before += layer.contours.edges_before;
  totals_.edges_after += layer.contours.outline.edges();
  totals_.max_deviation = std::max(totals_.max_deviation, layer.contours.max_deviation);
  totals_.max_regional_distortion =
      std::max(totals_.max_regional_distortion, layer.contours.max_regional_distortion);
  totals_.violations += layer.violations;
  totals_.ambiguous_squares += layer.ambiguous_squares;
  totals_.certified.add(layer);
  totals_.seconds += layer.seconds;
  totals_.seconds.sample = slicer_.sampling_seconds();
  if (!layer.program) return;
  totals_.filament_mm += layer.program->filament_mm;
  totals_.print_seconds += layer.program->seconds;
}

}  // namespace slipstick
