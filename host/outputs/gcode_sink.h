#pragma once

#include <filesystem>

#include "host/outputs/layer_sink.h"

namespace slipstick {

/// G-code into a file, or to standard output layer by layer if `path` is "-".
[[nodiscard]] Result<std::unique_ptr<LayerSink>> make_gcode_sink(const std::filesystem::path& path,
                                                                 const SinkContext& context);

}  // namespace slipstick
