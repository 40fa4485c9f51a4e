#include "core/solid/rbf_fill.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "core/solid/rbf_field.h"
#include "core/solid/rbf_winding.h"

namespace slipstick {
namespace {

// Halvings of the box.
constexpr int kHalvings = 10;
// Balls are no smaller than this share of the radius that holds the nearest point's neighbours:
// nearer to the surface, between its points, the winding number says nothing. Nor are they smaller
// than this share of the supports there, within which the quadrics are right.
constexpr double kFinestOfPoints = 0.7;
constexpr double kFinestOfSupports = 0.4;
// Halvings of a cell to prove that supports leave no gap in it.
constexpr int kPartHalvings = 3;
// A ball is this much larger than its cell, so that neighbours blend.
constexpr double kOverlap = 1.25;
// Winding numbers that are clear; between is a hole.
constexpr double kInside = 0.7;
constexpr double kOutside = 0.3;
// Of the radius that holds a point's neighbours: nearer than this, what is not clear is no hole.
constexpr double kHole = 1.2;
// How far from zero f is in a ball, in its radii: it outweighs the rims of supports that are wrong.
constexpr double kWeight = 4;

class Fill {
 public:
  Fill(const PointCloud& cloud, const PointIndex& index)
      : normals_(cloud.normals), index_(index), field_(cloud, index) {}

  void visit(Vec3 middle, double half, const std::vector<RbfFunction>& near, int halvings) {
    const Vec3 reach = half * Vec3{1, 1, 1};
    const std::vector<RbfFunction> kept = rbf_narrowed(near, {middle - reach, middle + reach});
    const double radius = kOverlap * std::numbers::sqrt3 * half;
    const PointIndex::Nearest nearest = index_.nearest(middle);
    if (nearest.distance >= radius) {
      const bool hole = nearest.distance > kHole * field_.reach(nearest.index);
      return check({middle, half, radius, hole}, kept);
    }
    if (halvings == 0) return;
    if (radius < finest(kept, nearest.index) && covered(middle, half, kept, kPartHalvings)) return;
    const double part = half / 2;
    for (int corner = 0; corner < 8; ++corner) {
      visit(middle + corner_of(corner, part), part, kept, halvings - 1);
    }
  }

  [[nodiscard]] std::vector<RbfFunction> take() { return std::move(found_); }

 private:
  [[nodiscard]] double finest(const std::vector<RbfFunction>& kept, std::size_t nearest) const {
    const auto smallest = std::min_element(
        kept.begin(), kept.end(),
        [](const RbfFunction& a, const RbfFunction& b) { return a.radius < b.radius; });
    return std::max(kFinestOfPoints * field_.reach(nearest),
                    smallest == kept.end() ? 0 : kFinestOfSupports * smallest->radius);
  }

  struct Cell {
    Vec3 middle;
    double half;
    double radius;  // of the ball about it
    bool far;       // from all points, so that it may lie in a hole
  };

  void check(const Cell& cell, const std::vector<RbfFunction>& kept) {
    const auto& [middle, half, radius, far] = cell;
    const WindingField::Value w = field_.at(middle);
    if (w.winding < kOutside && kept.empty()) return;
    const bool clear = w.winding < kOutside || w.winding > kInside;
    if (!clear && !far) return bridge(cell, kept);
    if (clear && agrees(middle, half, kept, w.winding > kInside)) return;
    const double size = kWeight * radius;
    RbfFunction ball{middle, radius, {w.winding > kInside ? -size : size}};
    if (!clear) {
      // From one clear value to the other as the winding number goes.
      const double scale = -2 * size / (kInside - kOutside);
      ball.quadric[0] = scale * (w.winding - 0.5);
      ball.quadric[1] = scale * w.slope.x;
      ball.quadric[2] = scale * w.slope.y;
      ball.quadric[3] = scale * w.slope.z;
    }
    found_.push_back(ball);
  }

  // Where supports leave a gap near points: the tangent plane of the nearest one, as far as that.
  void bridge(const Cell& cell, const std::vector<RbfFunction>& kept) {
    if (covered(cell.middle, cell.half, kept, kPartHalvings)) return;
    const std::size_t nearest = index_.nearest(cell.middle).index;
    const Vec3 n = normals_[nearest];
    const double height = dot(n, cell.middle - index_.points()[nearest]);
    found_.push_back({cell.middle, cell.radius, {height, n.x, n.y, n.z}});
  }

  static bool agrees(Vec3 middle, double half, const std::vector<RbfFunction>& kept, bool inside) {
    if (inside && !covered(middle, half, kept, kPartHalvings)) return false;
    return all_of(middle, half, [&](Vec3 p) { return rbf_inside(kept, p) == inside; });
  }

  // Whether all of the cell, or of each of its parts, is within one support: then there is no gap.
  static bool covered(Vec3 middle, double half, const std::vector<RbfFunction>& kept,
                      int halvings) {
    const Vec3 reach = half * Vec3{1, 1, 1};
    const Box3 cell{middle - reach, middle + reach};
    const bool held = std::any_of(kept.begin(), kept.end(), [&](const RbfFunction& f) {
      return farthest_square(cell, f.centre) < f.radius * f.radius;
    });
    if (held || halvings == 0) return held;
    for (int corner = 0; corner < 8; ++corner) {
      if (!covered(middle + corner_of(corner, half / 2), half / 2, kept, halvings - 1))
        return false;
    }
    return true;
  }

  static Vec3 corner_of(int corner, double part) {
    return {(corner & 1) != 0 ? part : -part, (corner & 2) != 0 ? part : -part,
            (corner & 4) != 0 ? part : -part};
  }

  // Whether it holds at 27 points of the cell.
  template <typename Condition>
  static bool all_of(Vec3 middle, double half, Condition holds) {
    for (int i = 0; i < 27; ++i) {
      const int x = i % 3, y = i / 3 % 3, z = i / 9;
      const Vec3 to{half * (x - 1), half * (y - 1), half * (z - 1)};
      if (!holds(middle + to)) return false;
    }
    return true;
  }

  std::span<const Vec3> normals_;
  const PointIndex& index_;
  WindingField field_;
  std::vector<RbfFunction> found_;
};

}  // namespace

std::vector<RbfFunction> fill_between(const std::vector<RbfFunction>& surface,
                                      const PointCloud& cloud, const PointIndex& index) {
  // Supports reach beyond the box of the points, and phantoms with them.
  Box3 box;
  for (const RbfFunction& f : surface) {
    const Vec3 reach = f.radius * Vec3{1, 1, 1};
    box = box.with(f.centre - reach).with(f.centre + reach);
  }
  const Vec3 size = box.size();
  Fill fill(cloud, index);
  fill.visit(box.centre(), std::max({size.x, size.y, size.z}) / 2, surface, kHalvings);
  return fill.take();
}

}  // namespace slipstick
