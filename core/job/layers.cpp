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

}  // namespace slipstick
