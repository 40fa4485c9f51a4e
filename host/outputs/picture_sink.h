#pragma once

#include <filesystem>

#include "host/outputs/layer_sink.h"

namespace slipstick {

/// One picture for all layers, or a folder with one for each.
enum class PictureLayout { kSheet, kFolder };

/// At most so many layers on a sheet, spread evenly over the job.
inline constexpr int kSheetTilesMax = 20;

/// Pictures as `.svg` or `.png`, by the extension of `path`. A folder's files are
/// `layer_00012.svg`.
[[nodiscard]] Result<std::unique_ptr<LayerSink>> make_picture_sink(
    const std::filesystem::path& path, PictureLayout layout, const SinkContext& context);

}  // namespace slipstick
