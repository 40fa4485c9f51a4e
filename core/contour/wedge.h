#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/contour/stick.h"

namespace slipstick {

/// A difference of two points in 1/65536 of a cell.
template <typename Number>
struct Ray {
  Number x{};
  Number y{};
};

template <typename Number>
[[nodiscard]] constexpr Number cross(Ray<Number> a, Ray<Number> b) {
  return a.x * b.y - a.y * b.x;
}

/// What can be seen from one point of a contour through the windows of the sticks that follow: a
/// cone, narrowed stick by stick. A line from its origin within the cone crosses every window
/// passed so far, in order.
///
/// Exact, in doubles for runs of up to `kSpanMax` sticks as well as in 64-bit integers for longer
/// ones: two neighbouring sticks bound one cell, so differences stay below (span + 1) 2^16, and the
/// products of a cross product below 2^52 in doubles and 2^60 in integers.
template <typename Number>
class Wedge {
 public:
  static constexpr std::size_t kSpanMax = std::is_floating_point_v<Number> ? 1000 : 8192;

  /// The next stick, from its inside end to its outside end; all of it is seen.
  Wedge(Ray<Number> inside, Ray<Number> outside) : left_(inside), right_(outside) {}
  template <typename Other>
  explicit Wedge(const Wedge<Other>& other)
      : left_{static_cast<Number>(other.left().x), static_cast<Number>(other.left().y)},
        right_{static_cast<Number>(other.right().x), static_cast<Number>(other.right().y)} {}

  /// Whether a line towards `point`, on the stick behind the windows passed, crosses them all.
  [[nodiscard]] bool sees(Ray<Number> point) const {
    return cross(right_, point) > 0 && cross(point, left_) > 0;
  }

  /// Whether any point of a window can be seen.
  [[nodiscard]] bool meets(Ray<Number> inside, Ray<Number> outside) const {
    return cross(right_, inside) > 0 && cross(outside, left_) > 0;
  }

  /// Passes a window. \pre It meets it. \return false if nothing can be seen behind it.
  [[nodiscard]] bool pass(Ray<Number> inside, Ray<Number> outside) {
    if (cross(inside, left_) >= 0) left_ = inside;
    if (cross(right_, outside) >= 0) right_ = outside;
    return cross(right_, left_) > 0;
  }

  [[nodiscard]] Ray<Number> left() const { return left_; }
  [[nodiscard]] Ray<Number> right() const { return right_; }

 private:
  Ray<Number> left_;
  Ray<Number> right_;
};

}  // namespace slipstick
