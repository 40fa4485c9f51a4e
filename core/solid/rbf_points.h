#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/box.h"

namespace slipstick {

/// Finds the points near a place: a uniform grid of at most a few cells a point.
///
/// What is found and in which order depends on the points alone.
class PointIndex {
 public:
  /// \pre `points` is not empty and outlives the index; all are finite, not all in one place.
  explicit PointIndex(std::span<const Vec3> points);

  [[nodiscard]] const Box3& box() const { return box_; }
  [[nodiscard]] std::span<const Vec3> points() const { return points_; }

  /// Calls `visit(index, squared distance)` for each point nearer to `p` than `radius`.
  template <typename Visit>
  void for_each_within(Vec3 p, double radius, Visit visit) const {
    const Cell low = cell_of(p - Vec3{radius, radius, radius});
    const Cell high = cell_of(p + Vec3{radius, radius, radius});
    for (int z = low.z; z <= high.z; ++z) {
      for (int y = low.y; y <= high.y; ++y) {
        const std::uint32_t end = offsets_[number_of({high.x, y, z}) + 1];
        for (std::uint32_t k = offsets_[number_of({low.x, y, z})]; k < end; ++k) {
          const Vec3 d = points_[items_[k]] - p;
          const double square = dot(d, d);
          if (square < radius * radius) visit(items_[k], square);
        }
      }
    }
  }

  struct Nearest {
    std::uint32_t index;
    double distance;
  };
  [[nodiscard]] Nearest nearest(Vec3 p) const;

  /// The distance to the `count`-th nearest point. \pre 0 < count <= number of points.
  [[nodiscard]] double reach_of(Vec3 p, std::size_t count) const;

 private:
  struct Cell {
    int x;
    int y;
    int z;
  };
  [[nodiscard]] Cell cell_of(Vec3 p) const;
  [[nodiscard]] std::size_t number_of(Cell c) const {
    return (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(cells_.y) +
            static_cast<std::size_t>(c.y)) *
               static_cast<std::size_t>(cells_.x) +
           static_cast<std::size_t>(c.x);
  }

  std::span<const Vec3> points_;
  Box3 box_;
  double size_ = 1;      // of a cell
  Cell cells_{1, 1, 1};  // how many
  std::vector<std::uint32_t> offsets_;
  std::vector<std::uint32_t> items_;
};

}  // namespace slipstick
