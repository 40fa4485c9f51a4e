#pragma once

#include "core/base/result.h"
#include "core/job/settings.h"

namespace slipstick {

/// The layers of a print: which planes are cut, and what thickness each stands for.
class LayerStack {
 public:
  static constexpr int kLayersMax = 200'000;

  /// Layers for a solid from z = 0 up to `height` mm: all whose middle lies below it, at least one.
  /// \return kInput if there would be more than `kLayersMax`.
  [[nodiscard]] static Result<LayerStack> over(double height, const SlicingSettings& settings);

  [[nodiscard]] int count() const { return count_; }
  /// Upper face of layer `i`, where the nozzle is.
  [[nodiscard]] double top(int i) const { return first_height_ + i * height_; }
  [[nodiscard]] double thickness(int i) const { return i == 0 ? first_height_ : height_; }
  /// Height of the slicing plane: the middle of the layer.
  [[nodiscard]] double middle(int i) const { return top(i) - thickness(i) / 2; }

 private:
  LayerStack(double first_height, double height, int count)
      : first_height_(first_height), height_(height), count_(count) {}

  double first_height_;
  double height_;
  int count_;
};

}  // namespace slipstick
