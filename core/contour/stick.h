#pragma once

#include <cstdint>

#include "core/base/check.h"
#include "core/image/grid.h"

namespace slipstick {

/// \file
/// Sticks (paper, section 3.2): the grid edges that a contour crosses.
///
/// A stick joins two neighbouring samples of the binary image of which one is inside the solid and
/// the other is not. Every contour vertex lives on exactly one stick and only ever slides along it.
/// That alone keeps contours free of self-intersection (proposition 3) and every sample on its own
/// side (proposition 4), so nothing downstream has to repair anything.

/// A point of the contour plane in 1/65536 of a cell, counted from node (0, 0) of the grid.
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend constexpr bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// (a - o) × (b - o): positive where o, a, b turn left. Exact: a window has at most 2^14 cells a
/// side, so differences are below 2^31 and the result below 2^62.
[[nodiscard]] constexpr std::int64_t cross(GridPoint o, GridPoint a, GridPoint b) {
  const std::int64_t ax = std::int64_t{a.x} - o.x, ay = std::int64_t{a.y} - o.y;
  const std::int64_t bx = std::int64_t{b.x} - o.x, by = std::int64_t{b.y} - o.y;
  return ax * by - ay * bx;
}

/// The way from the inside node of a stick to its outside node.
enum class Outward : std::uint8_t { kEast, kNorth, kWest, kSouth };

/// A grid edge between an inside and an outside node, named by the inside one.
struct Stick {
  std::int16_t column = 0;
  std::int16_t row = 0;
  Outward outward = Outward::kEast;

  friend constexpr bool operator==(const Stick&, const Stick&) = default;
};

/// A place strictly between the ends of a stick, in 65536ths from the inside node.
///
/// A stick is an open interval. This is not a nicety: a vertex on a node changes which side that
/// sample is on, and with closed sticks simplification loses pixels on almost every image. So the
/// type holds the distance, and no code can write 0 or 65536 into it.
class Place {
 public:
  static constexpr std::int64_t kLowest = 1;
  static constexpr std::int64_t kHighest = SliceGrid::kUnitsPerCell - 1;

  constexpr Place() = default;  ///< The middle, where marching squares starts.

  /// The nearest allowed place to `k`.
  [[nodiscard]] static constexpr Place clamped(std::int64_t k) {
    return Place(static_cast<std::uint16_t>(k < kLowest ? kLowest : k > kHighest ? kHighest : k));
  }

  [[nodiscard]] constexpr std::int32_t value() const { return k_; }

  friend constexpr bool operator==(const Place&, const Place&) = default;

 private:
  explicit constexpr Place(std::uint16_t k) : k_(k) {}

  std::uint16_t k_ = SliceGrid::kUnitsPerCell / 2;
};

/// Unit step of a direction.
struct Step {
  int x = 0;
  int y = 0;
};
[[nodiscard]] constexpr Step step(Outward outward) {
  switch (outward) {
    case Outward::kEast:
      return {1, 0};
    case Outward::kNorth:
      return {0, 1};
    case Outward::kWest:
      return {-1, 0};
    case Outward::kSouth:
      return {0, -1};
  }
  return {};
}

/// The inside node of a stick.
[[nodiscard]] constexpr GridPoint inside_node(Stick stick) {
  constexpr auto kCell = static_cast<std::int32_t>(SliceGrid::kUnitsPerCell);
  return {stick.column * kCell, stick.row * kCell};
}

/// The point `k` 65536ths along the stick, its ends (0 and 65536) allowed.
[[nodiscard]] constexpr GridPoint along(Stick stick, std::int32_t k) {
  const GridPoint node = inside_node(stick);
  const Step s = step(stick.outward);
  return {node.x + s.x * k, node.y + s.y * k};
}

[[nodiscard]] constexpr GridPoint position(Stick stick, Place place) {
  return along(stick, place.value());
}

}  // namespace slipstick
