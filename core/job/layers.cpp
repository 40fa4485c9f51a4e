#include "core/job/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slipstick {

Result<LayerStack> LayerStack::over(double height, const SlicingSettings& settings) {
  const double first = settings.first_layer_height, each = settings.layer_height;
  // Layer i > 0 has its middle at first + (i - 1/2)·each.
  const double count = std::max(1.0, std::ceil((height - first) / each + 0.5));
  if (!(count <= kLayersMax)) {
    return fail(ErrorCode::kInput,
                fmt::format("{} mm in layers of {} mm are more than {} layers; use a larger "
                            "--layer-height or a smaller --scale",
                            height, each, kLayersMax));
  }
  return LayerStack(first, each, static_cast<int>(count));
}

double LayerStack::aligned_sampling(const SlicingSettings& settings) {
  constexpr double kRounding = 1e-9;  // 0.3 / 0.1 is 3, not 4
  const double ratio = settings.layer_height / settings.sampling;
  if (ratio < 1 - kRounding) return settings.sampling;
  return settings.layer_height / std::ceil(ratio - kRounding * ratio);
}

bool LayerStack::aligned(double width) const {
  const auto whole = [width](double distance) {
    const double ratio = distance / width, nearest = std::round(ratio);
    return nearest >= 1 && std::abs(ratio - nearest) <= 1e-5 * nearest;
  };
  return count_ == 1 || (whole(middle(1) - middle(0)) && (count_ == 2 || whole(height_)));
}

}  // namespace slipstick
