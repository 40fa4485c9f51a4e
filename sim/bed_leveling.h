#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/gcode/parse.h"

namespace slipstick {

/// Bilinear bed leveling as a host sees it (AUTO_BED_LEVELING_BILINEAR of Marlin 2.1.2, 3 by 3
/// points): the grid that G29 measures and M420 reports. The bed itself is flat, and moves are not
/// bent.
class BedLeveling {
 public:
  static constexpr std::size_t kSide = 3;

  /// What G29 measures of a bed that is a little higher in the middle and at the right.
  void probe();
  /// M420 S V Z. \return What it prints.
  [[nodiscard]] std::string run(const GcodeCommand& command);
  /// The grid as G29 and M420 V print it.
  [[nodiscard]] std::string grid_text() const;

 private:
  std::array<double, kSide * kSide> heights_{};
  bool measured_ = false;
  bool on_ = false;
  double fade_height_ = 10;
};

}  // namespace slipstick
