#pragma once

#include "core/gcode/layer_program.h"
#include "core/job/settings.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// A layer as Marlin G-code: absolute positions, relative extrusion, retraction before long
/// travels, and retracted at its end, so that layers can be made in any order and joined. The only
/// place that rounds: positions to 0.001 mm, filament to 0.00001 mm with the remainder carried on.
[[nodiscard]] LayerProgram write_layer(const LayerToolpaths& layer, const PrintSettings& settings);

/// What comes before the first layer: the printer's own start, temperatures filled in.
[[nodiscard]] LayerProgram write_start(const PrintSettings& settings);

/// What comes after the last.
[[nodiscard]] LayerProgram write_end(const PrintSettings& settings);

}  // namespace slipstick
