#pragma once

#include <vector>

#include "core/image/bit_image.h"
#include "core/region/surface_probe.h"

namespace slipstick {

/// A run of nodes of one kind between two of the other, along a row or a column of an image.
struct ImageChord {
  SectionAxis axis = SectionAxis::kX;
  int line = 0;   ///< The row, or the column.
  int begin = 0;  ///< First node of the run.
  int end = 0;    ///< Behind the last one.
  bool inside = false;

  [[nodiscard]] int nodes() const { return end - begin; }
};

/// All chords of an image, inside and outside, rows first; the outside that reaches the border is
/// none.
[[nodiscard]] std::vector<ImageChord> chords_of(const BitImage& image);

}  // namespace slipstick
