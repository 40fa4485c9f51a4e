#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/contour/ledger.h"
#include "host/certified_totals.h"
#include "host/layer_slicer.h"
#include "host/ordered_crew.h"

namespace slipstick {

/// Which layers, how, and with how many threads.
struct SlicingRequest {
  PrintSettings settings;
  SliceGoal goal = SliceGoal::kToolpaths;
  int threads = 0;  ///< 0: one a core.
  int first_layer = 0;
  std::optional<int> end_layer;  ///< One past the last; nothing: all.
  /// Where layers may have other settings than the first; `settings` are its original ones.
  std::shared_ptr<SettingsTimeline> timeline = nullptr;
};

/// What a job adds up to, so far.
struct SlicingTotals {
  int layers = 0;
  std::size_t edges_before = 0;
  std::size_t edges_after = 0;
  double max_deviation = 0;            ///< mm
  double max_regional_distortion = 0;  ///< mm³
  std::size_t violations = 0;
  std::int64_t ambiguous_squares = 0;
  double filament_mm = 0;
  double print_seconds = 0;  ///< Estimated.
  CertifiedTotals certified;
  StepSeconds seconds;
};

/// A solid being sliced, just in time: layers are made ahead of the consumer by a bounded window
/// and no more. Peak memory does not depend on their number.
///
/// Threads: one consumer.
class SlicingJob {
 public:
  /// \return kInput if the lattice or the number of layers would be too large, the range is empty,
  /// or certification is strict and the solid has no formula to certify from.
  [[nodiscard]] static Result<std::unique_ptr<SlicingJob>> start(const PlacedSolid& placed,
                                                                 const SlicingRequest& request);

  /// Waits for the next layer, bottom to top. Nothing after the last.
  /// \return kInput as well where certification is strict and the layer is not proved.
  [[nodiscard]] Result<std::optional<SlicedLayer>> next();

  /// Whether `next` would not wait.
  [[nodiscard]] bool ready() const { return crew_->ready(); }

  [[nodiscard]] const SlicingTotals& totals() const { return totals_; }
  /// Of the layers handed over so far.
  [[nodiscard]] Topology topology() const { return ledger_.topology(); }
  [[nodiscard]] const SliceGrid& grid() const { return grid_; }
  [[nodiscard]] const LayerStack& stack() const { return slicer_.stack(); }
  [[nodiscard]] int first_layer() const { return first_; }
  [[nodiscard]] int end_layer() const { return end_; }
  [[nodiscard]] Certification certification() const { return certification_; }
  [[nodiscard]] int threads() const { return threads_; }

 private:
  SlicingJob(const PlacedSolid& placed, const SliceGrid& grid, const LayerStack& stack,
             const SlicingRequest& request);
  void add(const SlicedLayer& layer);

  const SliceGrid grid_;
  const int first_;
  const int end_;
  const int threads_;
  const Certification certification_;
  const std::shared_ptr<SettingsTimeline> timeline_;
  LayerSlicer slicer_;
  SlicingTotals totals_;
  StackLedger ledger_;
  std::unique_ptr<OrderedCrew<SlicedLayer>> crew_;  // last: its workers use what stands above
};

}  // namespace slipstick
