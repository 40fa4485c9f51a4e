#pragma once

#include <vector>

#include "core/contour/outline.h"
#include "core/image/bit_image.h"

namespace slipstick {

/// How far each inside node is from the outline, in mm: exact up to `reach`, `reach` for all
/// beyond.
///
/// Levels of this field are insets: {d >= a} is the image of the solid moved inwards by a, and its
/// contour has the same guarantees as any other.
class DistanceField {
 public:
  /// \pre `outline` separates the samples of `image`; `reach` > 0.
  DistanceField(const BitImage& image, const Outline& outline, double reach);

  /// 0 for outside nodes and beyond the window.
  [[nodiscard]] double at(int column, int row) const;

  /// The nodes at least `level` deep. \pre 0 < level <= reach.
  [[nodiscard]] BitImage at_least(double level) const;

  [[nodiscard]] const SliceGrid& grid() const { return grid_; }

 private:
  void approach(Vec2 a, Vec2 b, const BitImage& image);

  SliceGrid grid_;
  float reach_;
  std::vector<float> distances_;  // row by row
};

}  // namespace slipstick
