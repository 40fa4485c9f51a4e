#pragma once

#include <filesystem>
#include <optional>

#include "host/figures/figure_layer.h"
#include "host/figures/loops.h"

namespace slipstick {

/// What becomes of the contours of one layer by the paper's simplification (section 5).
struct Segmentation {
  std::vector<DrawnLoop> regions;  ///< Runs of vertices, ends included, as they were clustered.
  Outline simplified;              ///< Verified, and split where it had to be.
};

/// Of the contours of `layer` of `placed`, placed as the settings say, with their `alpha` and
/// `tolerance`.
[[nodiscard]] Segmentation segmentation_of(const PlacedSolid& placed, const FigureLayer& layer,
                                           const SlicingSettings& settings);

/// Left the clustering, each region in a colour of its own; right the simplified contours with
/// their vertices (fig. 12 of the paper). \param window what to show of it (mm); nothing: all.
/// \return kInput if no node is in the window.
[[nodiscard]] Result<void> draw_segments(const FigureLayer& layer, const Segmentation& segmentation,
                                         const std::optional<Box2>& window,
                                         const std::filesystem::path& path);

}  // namespace slipstick
