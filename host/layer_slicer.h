#pragma once

#include <memory>

#include "core/job/layers.h"
#include "core/job/placement.h"
#include "host/kept_images.h"
#include "host/layer_images.h"
#include "host/settings_timeline.h"
#include "host/sliced_layer.h"

namespace slipstick {

/// What is wanted of each layer.
enum class SliceGoal { kContours, kToolpaths };

/// One layer, from the solid to G-code: the straight line of ARCHITECTURE.md.
///
/// Threads: `slice` is called by several workers at once.
class LayerSlicer {
 public:
  /// \param settings of each layer; it outlives this.
  LayerSlicer(const PlacedSolid& placed, const SliceGrid& grid, const LayerStack& stack,
              SettingsTimeline& settings, SliceGoal goal);

  /// \return kInput if the solid is undefined somewhere in a plane that the layer needs.
  [[nodiscard]] Result<SlicedLayer> slice(int layer);

  /// Frees what only layers below `layer` need.
  void finished_below(int layer);

  /// Seconds spent sampling so far.
  [[nodiscard]] double sampling_seconds() const { return images_.seconds(); }

  [[nodiscard]] const LayerStack& stack() const { return stack_; }

 private:
  [[nodiscard]] SlicedLayer contours(int layer, const ImageWindow::Image& image) const;
  void certify(const BitImage& image, SlicedLayer& layer) const;
  [[nodiscard]] Simplified simplify(const ContourSet& contours) const;
  [[nodiscard]] Result<void> add_toolpaths(const SettingsTimeline::OfLayer& settings,
                                           SlicedLayer& layer);
  using Cancelled = std::vector<CancelledObject>;
  [[nodiscard]] Result<BitImage> common_part(int from, int to, const Cancelled& cancelled);

  const std::shared_ptr<const Solid> solid_;
  const Box3 bounds_;
  const LayerStack stack_;
  SettingsTimeline& settings_;
  const SlicingSettings slicing_;  // no layer has others
  const SliceGoal goal_;
  LayerImages images_;
  KeptImages kept_;
};

}  // namespace slipstick
