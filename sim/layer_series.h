#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/vec.h"

namespace slipstick {

/// \file
/// What shows only where layers are compared with those next to them: layers left out, and infill
/// that is missing.

/// What of a layer is kept for that, in order of printing. Millimetres.
struct LayerTrace {
  double top = 0;
  double height = 0;
  double cell = 0;  ///< Side of the largest square that fits into a void; 0 without.
  Vec2 cell_place;  ///< Its middle.
};

/// So many times as high, or as wide, as next to it is not what was meant.
inline constexpr double kOutOfSeries = 1.6;
/// Smaller voids are seams between beads, not cells of infill.
inline constexpr double kCellMin = 1;

/// A layer that is so much higher than the next ones that others are missing below it.
struct LayerGap {
  std::size_t above = 0;  ///< Index of that layer.
  int missing = 0;        ///< How many there should be below it.
  double height = 0;      ///< How high each of them.
};

/// The gaps of `layers`. The second layer is compared with the third alone, as the first one is
/// often thicker; of the first nothing can be told, nor where every other layer is left out.
[[nodiscard]] std::vector<LayerGap> gaps_in(std::span<const LayerTrace> layers);

/// Indices of layers with a void out of proportion: to those of the layers next to it that have
/// any, and to what is usual in the print (the median).
[[nodiscard]] std::vector<std::size_t> hollow_layers(std::span<const LayerTrace> layers);

}  // namespace slipstick
