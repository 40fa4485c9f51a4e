#include "core/solid/rbf_fill.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
// A ball is this much larger than its cell, so that neighbours blend.
constexpr double kOverlap = 1.25;
// Winding numbers that are clear; between is a hole.
constexpr double kInside = 0.7;
constexpr double kOutside = 0.3;
// How far from zero f is in a ball, in its radii: it outweighs the rims of supports that are wrong.
constexpr double kWeight = 4;

class Fill {
 public:
  Fill(const PointCloud& cloud, const PointIndex& index) : index_(index), field_(cloud, index) {}

  void visit(Vec3 middle, double half, const std::vector<RbfFunction>& near, int halvings) {
    const Vec3 reach = half * Vec3{1, 1, 1};
    const std::vector<RbfFunction> kept = rbf_narrowed(near, {middle - reach, middle + reach});
    const double radius = kOverlap * std::numbers::sqrt3 * half;
    const PointIndex::Nearest nearest = index_.nearest(middle);
    if (nearest.distance >= radius) return check(middle, half, radius, kept);
    if (halvings == 0 || radius < finest(kept, nearest.index)) return;
    const double part = half / 2;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 to{(corner & 1) != 0 ? part : -part, (corner & 2) != 0 ? part : -part,
                    (corner & 4) != 0 ? part : -part};
      visit(middle + to, part, kept, halvings - 1);
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

  void check(Vec3 middle, double half, double radius, const std::vector<RbfFunction>& kept) {
    const WindingField::Value w = field_.at(middle);
    if (w.winding < kOutside && kept.empty()) return;
    const bool clear = w.winding < kOutside || w.winding > kInside;
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

  // Whether f is on that side at 27 points of the cell.
  static bool agrees(Vec3 middle, double half, const std::vector<RbfFunction>& kept, bool inside) {
    for (int i = 0; i < 27; ++i) {
      const Vec3 to{half * (i % 3 - 1), half * (i / 3 % 3 - 1), half * (i / 9 - 1)};
      if (rbf_inside(kept, middle + to) != inside) return false;
    }
    return true;
  }

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
