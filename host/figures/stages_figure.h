#pragma once

#include <filesystem>
#include <optional>

#include "core/job/settings.h"
#include "host/figures/figure_layer.h"

namespace slipstick {

/// Nodes along a side of the window that `draw_stages` chooses, and the most it can draw.
inline constexpr int kStageNodes = 24;
inline constexpr int kStageNodesMax = 120;

/// The window (mm) round the stretch where the longest contour, smoothed by sliding, turns most.
/// \pre The image has a contour.
[[nodiscard]] Box2 most_curved_window(const BitImage& image, Ambiguity ambiguity);

/// One window of a layer five times, side by side (fig. 10 of the paper): contours through the
/// middles of the sticks, after sliding, after projection, after ordinary Laplacian smoothing, and
/// on the roots of f; nodes and sticks thinly below them.
///
/// \param layer a layer of `placed`.
/// \param window in mm; nothing: `most_curved_window`.
/// \return kInput if no node or no contour is in the window, or it is more than `kStageNodesMax`
/// nodes wide.
[[nodiscard]] Result<void> draw_stages(const PlacedSolid& placed, const FigureLayer& layer,
                                       Ambiguity ambiguity, const std::optional<Box2>& window,
                                       const std::filesystem::path& path);

}  // namespace slipstick
