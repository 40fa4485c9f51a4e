#pragma once

#include "core/gcode/layer_program.h"
#include "core/job/settings.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// A layer as Marlin G-code: absolute positions, relative extrusion, retraction before long
/// travels, and retracted at its end, so that layers can be made in any order and joined. The only
/// place that rounds: positions to 0.001 mm, filament to 0.00001 mm with the remainder carried on.
[[nodiscard]] LayerProgram write_layer(const LayerToolpaths& layer, const PrintSettings& settings);
/// The same, on a layer that was written with the settings `below`: begins by saying what of them
/// the printer keeps from layer to layer and is no longer so. For the first layer they are those of
/// `write_start`.
[[nodiscard]] LayerProgram write_layer(const LayerToolpaths& layer, const PrintSettings& settings,
                                       const PrintSettings& below);

/// What comes before the first layer: the printer's own start, temperatures filled in.
[[nodiscard]] LayerProgram write_start(const PrintSettings& settings);

/// What comes after the last.
[[nodiscard]] LayerProgram write_end(const PrintSettings& settings);

}  // namespace slipstick
