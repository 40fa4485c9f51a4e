#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/contour/audit.h"
#include "core/contour/audit_exact.h"

namespace slipstick::audit_exact {

/// One edge of a loop, with its number in the loop and that of the edge after it.
struct Edge {
  Point from;
  Point to;
  std::size_t loop = 0;
  std::size_t index = 0;
  std::size_t next = 0;
};

/// Half-open: true for one of two edges that meet at height `y` and go on.
[[nodiscard]] constexpr bool spans(const Edge& e, std::int64_t y) {
  return (e.from.y <= y) != (e.to.y <= y);
}

/// Whether the edge crosses the ray from `p` to the left.
[[nodiscard]] constexpr bool left_of(const Edge& e, Point p) {
  if (!spans(e, p.y)) return false;
  const bool upward = e.to.y > e.from.y;
  return (turn(e.from, e.to, p) < 0) == upward;
}

/// Where an edge crosses a height.
struct Crossing {
  std::int64_t x = 0;  ///< Rounded down.
  bool exact = false;  ///< Nothing was lost by rounding.

  friend constexpr bool operator<(const Crossing& a, const Crossing& b) { return a.x < b.x; }
};

/// \pre `spans(e, y)`.
[[nodiscard]] constexpr Crossing crossing(const Edge& e, std::int64_t y) {
  Wide run = Wide{y - e.from.y} * (e.to.x - e.from.x);
  Wide rise = Wide{e.to.y} - e.from.y;
  if (rise < 0) {
    run = -run;
    rise = -rise;
  }
  Wide quotient = run / rise;
  const Wide rest = run % rise;
  if (rest < 0) --quotient;
  return {e.from.x + static_cast<std::int64_t>(quotient), rest == 0};
}

/// All edges of a layer, found by place: a table of square buckets, each edge in every bucket that
/// its box meets.
class EdgeBuckets {
 public:
  /// \pre All points are representable and no loop is empty.
  explicit EdgeBuckets(const std::vector<AuditLoop>& loops);

  /// Each pair of edges whose boxes share a bucket, at least once.
  void for_each_close_pair(const std::function<void(const Edge&, const Edge&)>& visit) const;

  /// Each edge that may span height `y`, once.
  void for_each_in_row_of(std::int64_t y, const std::function<void(const Edge&)>& visit) const;

 private:
  struct Window {
    std::size_t left, right, bottom, top;
  };
  [[nodiscard]] Window window(const Edge& edge) const;
  [[nodiscard]] std::size_t column_of(std::int64_t x) const;
  [[nodiscard]] std::size_t row_of(std::int64_t y) const;

  std::vector<Edge> edges_;
  Point low_;
  Point high_;
  std::int64_t bucket_ = 1;  // side
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::vector<std::vector<std::uint32_t>> by_row_;
};

}  // namespace slipstick::audit_exact
