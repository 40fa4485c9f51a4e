#pragma once

#include <filesystem>

#include "host/outputs/layer_sink.h"

namespace slipstick {

/// Contours as JSON Lines: a header, then one line a layer. Coordinates read back to the very
/// points that were verified. The header's `grid_width` is the lattice's exact width; `sampling` is
/// what was asked for.
[[nodiscard]] Result<std::unique_ptr<LayerSink>> make_contours_sink(
    const std::filesystem::path& path, const SinkContext& context);

}  // namespace slipstick
