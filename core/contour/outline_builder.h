#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/contour/chord.h"
#include "core/contour/frechet.h"
#include "core/contour/simplify.h"

namespace slipstick {

/// Puts an `Outline` together, loop by loop, and keeps the books of a `Simplified`.
/// The one place that can make an outline: it checks every edge against the sticks it skips.
class OutlineBuilder {
 public:
  explicit OutlineBuilder(const ContourSet& contours) : contours_(contours) {}

  /// Adds `loop` with the vertices `kept` (ascending, at least 3). \pre Every run between
  /// neighbours stabs.
  void add(const ContourSet::Loop& loop, std::span<const std::size_t> kept);

  /// The same for vertices that have moved on their sticks.
  /// \param bounds of `frechet_bounds`.
  void add(const ContourSet::Loop& loop, std::span<const Kept> kept,
           std::span<const double> bounds);

  /// Counts a regional distortion (mm³) into the maximum.
  void note_distortion(double distortion);

  [[nodiscard]] Simplified finish();

 private:
  const ContourSet& contours_;
  std::vector<Outline::Loop> loops_;
  double max_deviation_ = 0;  // in 1/65536 of a cell
  double max_distortion_ = 0;
};

}  // namespace slipstick
