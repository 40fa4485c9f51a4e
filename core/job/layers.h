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

  /// The sampling distance of which layers are a whole number thick: all slices are then planes of
  /// one cubic lattice and sections of one surface. `settings.sampling` or a little less; just that
  /// where layers are thinner.
  [[nodiscard]] static double aligned_sampling(const SlicingSettings& settings);

  /// Whether all slicing planes are whole multiples of `width` apart, to one part in 100,000: the
  /// quantum of lattice widths.
  [[nodiscard]] bool aligned(double width) const;

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
