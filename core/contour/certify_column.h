#pragma once

#include <cstdint>
#include <optional>

#include "core/base/box.h"
#include "core/contour/certify.h"

namespace slipstick {

/// Whether the surface has no horizontal tangent plane in the box: some horizontal direction in
/// which f only rises or only falls.
[[nodiscard]] bool no_critical_point(const GradientRange& range);

/// What a column of a slab may hold.
struct ColumnVerdict {
  std::optional<SlabEvent::Kind> event;
  double low = 0;  ///< mm: the heights between which boxes failed.
  double high = 0;
  std::int64_t boxes = 0;  ///< Looked at.
};

/// Splits `column` in eight, `kEventSplits` times, wherever that may show more.
[[nodiscard]] ColumnVerdict judge_column(Field& field, const Box3& column);

}  // namespace slipstick
