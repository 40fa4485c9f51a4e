#include "core/image/grid.h"

#include <fmt/format.h>

#include <cmath>

namespace slipstick {
namespace {

constexpr double kWidthQuantum = 0x1p-22;

// Beyond this the lattice index times 65536 no longer is an exact double.
constexpr double kReachMax = 10000;  // mm

bool within_reach(const Box2& area) {
  return !area.empty() && area.low.x >= -kReachMax && area.low.y >= -kReachMax &&
         area.high.x <= kReachMax && area.high.y <= kReachMax;
}

}  // namespace

Result<SliceGrid> SliceGrid::over(const Box2& area, double sampling) {
  if (!(sampling >= kWidthMin && sampling <= kWidthMax)) {
    return fail(ErrorCode::kInput, fmt::format("sampling {} mm is out of range {} to {} mm",
                                               sampling, kWidthMin, kWidthMax));
  }
  if (!within_reach(area)) {
    return fail(ErrorCode::kInput, fmt::format("the area to be sliced is empty or reaches beyond "
                                               "{} mm; scale or move the model",
                                               kReachMax));
  }
  SliceGrid grid;
  grid.width_ = std::floor(sampling / kWidthQuantum) * kWidthQuantum;
  // One node beyond the area on each side is outside for certain; one more is room for rounding.
  const auto first = [&](double low) { return std::floor(low / grid.width_) - 2; };
  const auto count = [&](double low, double high) {
    return std::ceil(high / grid.width_) + 2 - first(low) + 1;
  };
  const double columns = count(area.low.x, area.high.x);
  const double rows = count(area.low.y, area.high.y);
  const double most = std::max(columns, rows);
  if (most > kNodesMax) {
    return fail(ErrorCode::kInput,
                fmt::format("sampling at {} mm needs {:.0f} nodes a side, at most {} are possible; "
                            "use --sampling {:.4g} or coarser",
                            sampling, most, kNodesMax, sampling * most / (kNodesMax - 8)));
  }
  grid.first_column_ = static_cast<std::int64_t>(first(area.low.x));
  grid.first_row_ = static_cast<std::int64_t>(first(area.low.y));
  grid.columns_ = static_cast<int>(columns);
  grid.rows_ = static_cast<int>(rows);
  return grid;
}

}  // namespace slipstick
