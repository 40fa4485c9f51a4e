#pragma once

#include <cstdint>

#include "core/image/grid.h"

namespace slipstick {

/// A crossing on one stick between a place that is inside and one that is not, closed in by values
/// of f: `next` says where to look, `take` what was seen there, until the two are 1/65536 of a cell
/// apart. Where f is monotone that pair is the only one, however it was found.
///
/// Smooth values need three to five looks: a chord, then quadratics through three values, then the
/// neighbour. Any values at all, NaN and infinities too, close it within `kLooksMax`.
class Bracket {
 public:
  /// So many looks follow the values; after them the rest is halved.
  static constexpr int kQuickLooks = 8;
  static constexpr int kLooksMax = kQuickLooks + 16;

  /// \param inside f at the inside node (<= 0), \param outside f at the outside node.
  Bracket(double inside, double outside)
      : f_inside_(inside), f_outside_(outside), next_(choose()) {}

  [[nodiscard]] bool closed() const { return outside_ - inside_ == 1; }
  /// The inside end, in 65536ths of the stick.
  [[nodiscard]] std::int32_t inside() const { return inside_; }

  /// Strictly between the ends. \pre Not closed.
  [[nodiscard]] std::int32_t next() const { return next_; }
  /// f at `next()`. NaN is outside.
  void take(double value);

 private:
  [[nodiscard]] std::int32_t choose() const;
  [[nodiscard]] double chord() const;
  [[nodiscard]] double quadratic() const;
  [[nodiscard]] bool holds(double at) const { return at > inside_ && at < outside_; }

  std::int32_t inside_ = 0;
  std::int32_t outside_ = SliceGrid::kUnitsPerCell;
  std::int32_t before_ = 0;  // an end that was given up
  int looks_ = 0;
  double f_inside_;
  double f_outside_;
  double f_before_ = 0;
  std::int32_t next_;
};

}  // namespace slipstick
