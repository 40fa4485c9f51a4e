#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/contour/chord.h"

namespace slipstick {

/// The windows of one loop: on every stick the part that an edge may cross or end on.
///
/// A window reaches as far to both sides of the contour's own place as keeps an edge through it
/// within the tolerance of the contour, measured along the contour's normal to first order:
/// tolerance / |normal · stick|, at most `kSlantMax` times the tolerance. Sticks are open, so a
/// window never reaches a node; it always holds a part of its stick.
class Corridor {
 public:
  /// Candidates for a vertex on one stick: the inner end of its window, the contour's own place,
  /// the outer end.
  static constexpr std::size_t kCandidates = 3;
  static constexpr std::size_t kOwnPlace = 1;
  /// Where the contour runs nearly along a stick, its window is no longer than so many tolerances.
  static constexpr double kSlantMax = 20;

  /// \param tolerance in 1/65536 of a cell.
  void build(const LoopView& loop, double tolerance);

  /// Makes the window of stick `i` as long as the tolerance itself, whatever the slant: then an
  /// edge through it is within the tolerance there, beyond doubt.
  void tighten(std::size_t i);

  [[nodiscard]] std::size_t size() const { return sticks_.size(); }
  [[nodiscard]] Place place(std::size_t i, std::size_t candidate) const {
    return places_[i][candidate];
  }
  /// The candidates of stick `i` as points, inner end first.
  [[nodiscard]] const std::array<GridPoint, kCandidates>& points(std::size_t i) const {
    return points_[i];
  }

 private:
  void set(std::size_t i, double reach);

  double tolerance_ = 0;
  std::vector<Stick> sticks_;
  std::vector<std::array<Place, kCandidates>> places_;
  std::vector<std::array<GridPoint, kCandidates>> points_;
};

}  // namespace slipstick
