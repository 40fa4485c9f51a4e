#include "core/solid/mesh_model_intervals.h"

#include <bit>
#include <limits>

#include "core/base/check.h"

namespace slipstick {

IntervalIndex::IntervalIndex(std::span<const CoordinateRange> intervals) {
  SLIPSTICK_CHECK(intervals.size() < std::numeric_limits<std::uint32_t>::max());
  if (intervals.empty()) return;
  low_ = intervals[0].low;
  high_ = intervals[0].high;
  for (const CoordinateRange& i : intervals) {
    low_ = std::min(low_, i.low);
    high_ = std::max(high_, i.high);
  }
  const double inverse = 1 / (high_ - low_);
  per_range_ = std::isfinite(inverse) ? inverse : 0;
  levels_ = std::min(static_cast<int>(std::bit_width(intervals.size())), kLevelsMax);

  // Counting sort by cell.
  std::vector<std::uint32_t> cells;
  cells.reserve(intervals.size());
  offsets_.assign(first_cell(levels_) + 1, 0);
  for (const CoordinateRange& i : intervals) {
    cells.push_back(static_cast<std::uint32_t>(cell_of(i)));
    ++offsets_[cells.back() + 1];
  }
  for (std::size_t c = 1; c < offsets_.size(); ++c) offsets_[c] += offsets_[c - 1];
  std::vector<std::uint32_t> next = offsets_;
  items_.resize(intervals.size());
  for (std::uint32_t i = 0; i < intervals.size(); ++i) items_[next[cells[i]]++] = i;
}

std::size_t IntervalIndex::cell_of(const CoordinateRange& interval) const {
  // Twice the length leaves room for the rounding of cell_of: a value in the interval is less than
  // one whole cell above its lower end.
  const double share = 2 * (interval.high - interval.low) * per_range_;
  int level = levels_ - 1;
  while (level > 0 && std::ldexp(share, level) > 1) --level;
  return first_cell(level) + cell_of(interval.low, level);
}

}  // namespace slipstick
