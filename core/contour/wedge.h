#pragma once

#include <cstdint>

#include "core/contour/stick.h"

namespace slipstick {

/// What can be seen from one point of a contour through the windows of the sticks that follow: a
/// cone, narrowed stick by stick. A line from its origin within the cone crosses every window
/// passed so far, in order.
///
/// Exact in 64 bits as long as no more than `kSpanMax` sticks lie between the origin and what is
/// looked at: two neighbouring sticks bound one cell, so differences stay below 2^29 + 2^16 and
/// cross products below 2^60.
class Wedge {
 public:
  static constexpr std::size_t kSpanMax = 8192;

  /// Looks from `origin` at the next stick, between its inside end `left` and outside end `right`;
  /// all of it is seen.
  Wedge(GridPoint origin, GridPoint left, GridPoint right)
      : origin_(origin), left_(towards(left)), right_(towards(right)) {}

  /// Whether a line from the origin to `point`, on the stick behind the windows passed, crosses
  /// them all.
  [[nodiscard]] bool sees(GridPoint point) const {
    const Ray ray = towards(point);
    return cross(right_, ray) > 0 && cross(ray, left_) > 0;
  }

  /// Passes the window from `left` to `right`. \return false if nothing can be seen behind it.
  [[nodiscard]] bool pass(GridPoint left, GridPoint right) {
    const Ray a = towards(left), b = towards(right);
    if (cross(right_, a) <= 0 || cross(b, left_) <= 0) return false;
    if (cross(left_, a) <= 0) left_ = a;
    if (cross(right_, b) >= 0) right_ = b;
    return cross(right_, left_) > 0;
  }

 private:
  struct Ray {
    std::int64_t x;
    std::int64_t y;
  };
  static std::int64_t cross(Ray a, Ray b) { return a.x * b.y - a.y * b.x; }
  [[nodiscard]] Ray towards(GridPoint p) const {
    return {std::int64_t{p.x} - origin_.x, std::int64_t{p.y} - origin_.y};
  }

  GridPoint origin_;
  Ray left_;
  Ray right_;
};

}  // namespace slipstick
