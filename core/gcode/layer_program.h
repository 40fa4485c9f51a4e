#pragma once

#include <cstdint>
#include <string>

namespace slipstick {

/// The G-code of one complete layer, or of the start or end of a print.
///
/// Extrusion is relative (M83) and a layer begins with an absolute travel, so layers can be made in
/// any order and joined. No line is longer than 80 bytes; a comment stands on a line of its own.
struct LayerProgram {
  int layer = 0;
  std::string text;    ///< Lines, each ended by '\n'.
  double seconds = 0;  ///< Estimate of its printing time.
  double filament_mm = 0;
};

}  // namespace slipstick
