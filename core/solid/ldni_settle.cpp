#include "core/solid/ldni_settle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace slipstick {
namespace {

constexpr double kPerUnit = 1.0 / LdniGrid::kUnits;
constexpr double kMatch = 3;       // widths that depths of one surface differ by at most
constexpr double kFitting = 0.02;  // widths: a normal that foretells so well stays
constexpr double kWrongMost = 1;   // what a neighbour counts at most, one across an edge for one

struct Neighbour {
  int across_i;
  int across_j;
  double rise;  // of the depth, in widths
  LdniNormal normal;
};

// Up to four, one on each side.
struct Around {
  std::array<std::optional<Neighbour>, 4> sides;
};

class Settler {
 public:
  Settler(const LdniRays& rays, const LdniGrid& grid, std::size_t axis)
      : rays_(rays), grid_(grid), axis_(axis) {}

  // Of which depths are differences, as far as there are neighbours.
  [[nodiscard]] LdniNormal of_differences(int i, int j, std::size_t k) const {
    const std::uint32_t depth = rays_.of(grid_.ray(i, j))[k].depth;
    const auto& [right, left, above, below] = look_around(i, j, k, depth).sides;
    std::array<double, 3> n{};
    n[axis_] = 1;
    n[(axis_ + 1) % 3] = -slope(right, left);
    n[(axis_ + 2) % 3] = -slope(above, below);
    return LdniNormal::of({n[0], n[1], n[2]}).value();
  }

  [[nodiscard]] LdniNormal settled(int i, int j, std::size_t k) const {
    const LdniSample& sample = rays_.of(grid_.ray(i, j))[k];
    const Around around = look_around(i, j, k, sample.depth);
    const double own = misfit(sample.normal, around);
    if (own <= kFitting) return sample.normal;
    LdniNormal best = sample.normal;
    double least = 0.5 * own;
    const auto consider = [&](const LdniNormal& normal) {
      if (const double wrong = misfit(normal, around); wrong < least) {
        least = wrong;
        best = normal;
      }
    };
    for (const auto& side : around.sides) {
      if (side) consider(side->normal);
    }
    consider(of_differences(i, j, k));
    return best;
  }

 private:
  [[nodiscard]] Around look_around(int i, int j, std::size_t k, std::uint32_t depth) const {
    constexpr std::array<std::array<int, 2>, 4> kSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    Around around;
    for (std::size_t side = 0; side < kSides.size(); ++side) {
      const auto [di, dj] = kSides[side];
      const int u = i + di, v = j + dj;
      if (u < 0 || v < 0 || u >= grid_.resolution() || v >= grid_.resolution()) continue;
      if (const LdniSample* other = match(rays_.of(grid_.ray(u, v)), k % 2, depth)) {
        const double rise = (double{1} * other->depth - depth) * kPerUnit;
        around.sides[side] = Neighbour{di, dj, rise, other->normal};
      }
    }
    return around;
  }

  // The sample next to `depth` that goes the same way, in or out.
  static const LdniSample* match(std::span<const LdniSample> ray, std::size_t way,
                                 std::uint32_t depth) {
    const LdniSample* nearest = nullptr;
    double least = kMatch;
    for (std::size_t k = way; k < ray.size(); k += 2) {
      const double off = std::abs(double{1} * ray[k].depth - depth) * kPerUnit;
      if (off >= least) continue;
      least = off;
      nearest = &ray[k];
    }
    return nearest;
  }

  // By how much a tangent plane misses the depths beside it, on average; none of them, none missed.
  [[nodiscard]] double misfit(const LdniNormal& normal, const Around& around) const {
    const double along = normal.along(axis_);
    double sum = 0;
    int count = 0;
    for (const auto& side : around.sides) {
      if (!side) continue;
      const double slope = normal.along((axis_ + 1) % 3) * side->across_i +
                           normal.along((axis_ + 2) % 3) * side->across_j;
      const double wrong = along == 0 ? kWrongMost : std::abs(side->rise + slope / along);
      sum += std::min(wrong, kWrongMost);
      ++count;
    }
    return count == 0 ? 0 : sum / count;
  }

  static double slope(const std::optional<Neighbour>& next, const std::optional<Neighbour>& last) {
    if (next && last) return 0.5 * (next->rise - last->rise);
    if (next) return next->rise;
    return last ? -last->rise : kMatch;
  }

  const LdniRays& rays_;
  const LdniGrid& grid_;
  std::size_t axis_;
};

// The same rays with the normal that `normal(i, j, k)` gives sample k of each.
template <typename Normal>
LdniRays with_normals(const LdniRays& rays, const LdniGrid& grid, Normal normal) {
  LdniRays result = rays;
  for (int j = 0; j < grid.resolution(); ++j) {
    for (int i = 0; i < grid.resolution(); ++i) {
      const std::uint32_t first = rays.first[grid.ray(i, j)];
      for (std::size_t k = 0; k < rays.of(grid.ray(i, j)).size(); ++k) {
        result.samples[first + k].normal = normal(i, j, k);
      }
    }
  }
  return result;
}

}  // namespace

LdniRays settled(const LdniRays& rays, const LdniGrid& grid, std::size_t axis) {
  const Settler settler(rays, grid, axis);
  return with_normals(rays, grid,
                      [&](int i, int j, std::size_t k) { return settler.settled(i, j, k); });
}

LdniRays with_normals_of_differences(const LdniRays& rays, const LdniGrid& grid, std::size_t axis) {
  const Settler settler(rays, grid, axis);
  return with_normals(rays, grid,
                      [&](int i, int j, std::size_t k) { return settler.of_differences(i, j, k); });
}

}  // namespace slipstick
