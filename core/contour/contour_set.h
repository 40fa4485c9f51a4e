#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/contour/stick.h"
#include "core/image/grid.h"

namespace slipstick {

/// Which samples of an ambiguous square (paper, fig. 7 d) hang together. One rule for a whole
/// print: the three-dimensional argument needs it (a union of balls about the inside samples joins
/// them).
enum class Ambiguity : std::uint8_t { kSolid, kVoid };

/// All closed contours of one layer before simplification: loops of sticks, a place on each.
///
/// Only `trace` makes one, so every loop closes, every stick is in exactly one loop and the solid
/// lies on the left. Places can be changed, sticks cannot: smoothing cannot break a contour.
class ContourSet {
 public:
  struct Loop {
    std::size_t first = 0;  ///< Index of its first stick.
    std::size_t count = 0;  ///< At least 4.
    int depth = 0;          ///< 0 outer boundary, 1 hole, 2 island in it, …
  };

  [[nodiscard]] const SliceGrid& grid() const { return grid_; }
  [[nodiscard]] std::span<const Loop> loops() const { return loops_; }
  [[nodiscard]] std::span<const Stick> sticks() const { return sticks_; }
  [[nodiscard]] std::span<const Place> places() const { return places_; }
  [[nodiscard]] std::span<Place> places() { return places_; }
  /// Squares of the image in which `Ambiguity` had to decide.
  [[nodiscard]] std::int64_t ambiguous_squares() const { return ambiguous_squares_; }

  [[nodiscard]] std::span<const Stick> sticks(const Loop& loop) const {
    return sticks().subspan(loop.first, loop.count);
  }
  [[nodiscard]] std::span<const Place> places(const Loop& loop) const {
    return places().subspan(loop.first, loop.count);
  }
  [[nodiscard]] std::span<Place> places(const Loop& loop) {
    return places().subspan(loop.first, loop.count);
  }

 private:
  friend class Tracer;
  explicit ContourSet(const SliceGrid& grid) : grid_(grid) {}

  SliceGrid grid_;
  std::vector<Loop> loops_;
  std::vector<Stick> sticks_;
  std::vector<Place> places_;
  std::int64_t ambiguous_squares_ = 0;
};

}  // namespace slipstick
