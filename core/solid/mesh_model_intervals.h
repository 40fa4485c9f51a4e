#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace slipstick {

/// A closed interval of numbers. \pre low <= high, both finite.
struct CoordinateRange {
  double low = 0;
  double high = 0;
};

/// Finds, among many intervals, those that hold a value, at a cost near their number.
///
/// A loose binary grid: level l divides the whole range into 2^l cells, and an interval lies in the
/// finest level whose cells are at least twice as long, in the cell of its lower end. So on each
/// level only two cells can hold an interval with a given value: the value's own and the one below.
class IntervalIndex {
 public:
  IntervalIndex() = default;
  explicit IntervalIndex(std::span<const CoordinateRange> intervals);

  /// Calls `visit(i)` for each interval i that holds `value`, and for some that do not.
  template <typename Visit>
  void for_each_near(double value, Visit visit) const {
    if (!(value >= low_ && value <= high_)) return;
    for (int level = 0; level < levels_; ++level) {
      const std::size_t cell = cell_of(value, level);
      const std::size_t first = first_cell(level) + (cell > 0 ? cell - 1 : 0);
      const std::size_t end = first_cell(level) + cell + 1;
      for (std::uint32_t k = offsets_[first]; k < offsets_[end]; ++k) visit(items_[k]);
    }
  }

 private:
  static constexpr int kLevelsMax = 16;

  [[nodiscard]] static std::size_t first_cell(int level) { return (std::size_t{1} << level) - 1; }
  [[nodiscard]] std::size_t cell_of(double value, int level) const {
    const double cells = static_cast<double>(std::uint32_t{1} << level);
    const double cell = std::floor((value - low_) * per_range_ * cells);
    return static_cast<std::size_t>(std::clamp(cell, 0.0, cells - 1));
  }
  [[nodiscard]] std::size_t cell_of(const CoordinateRange& interval) const;

  double low_ = 0;
  double high_ = -1;
  double per_range_ = 0;  // 1 / (high_ - low_), 0 for a point.
  int levels_ = 0;
  std::vector<std::uint32_t> offsets_;  // Of the cells of all levels, coarse to fine, in items_.
  std::vector<std::uint32_t> items_;
};

}  // namespace slipstick
