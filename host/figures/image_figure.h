#pragma once

#include <filesystem>
#include <optional>

#include "host/figures/figure_layer.h"

namespace slipstick {

/// The longest side of a picture up to which nodes are drawn larger than one pixel each.
inline constexpr int kImageSide = 800;

/// How wide a node is drawn, in whole pixels.
[[nodiscard]] int node_pixels(const NodeWindow& nodes);

/// The binary image of a layer (figs. 5 and 6 of the paper): inside nodes dark, outside ones white;
/// a `.png` without frame or caption. Where nodes are eight pixels or wider, they are discs, full
/// and hollow, as in fig. 5 c.
///
/// \param window what to show of it (mm); nothing: all.
/// \return kInput if no node is in the window.
[[nodiscard]] Result<void> draw_image(const FigureLayer& layer, const std::optional<Box2>& window,
                                      const std::filesystem::path& path);

}  // namespace slipstick
