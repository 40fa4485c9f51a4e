#pragma once

#include <optional>
#include <span>

#include "sim/pixel_image.h"
#include "sim/regions.h"

namespace slipstick {

/// How pixels hang together: by their sides, or at corners too.
enum class Steps : std::uint8_t { kSides, kCorners };

/// The middle of a shortest way, counted in steps from pixel to pixel of `ground`, from a pixel of
/// `from` to one of `to`: where the thread is that joins the two. Of several ways always the same.
/// Nothing if no way leads there. Runs lie in the frame of `ground`.
[[nodiscard]] std::optional<Vec2> middle_of_shortest_way(const PixelImage& ground,
                                                         std::span<const PixelRun> from,
                                                         std::span<const PixelRun> to, Steps steps);

}  // namespace slipstick
