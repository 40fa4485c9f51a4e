#include "core/solid/rbf_winding.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace slipstick {
namespace {

// The points among which each shares the disc that holds them.
constexpr std::size_t kAreaPoints = 8;
constexpr std::size_t kLeafPoints = 8;
// Groups farther away than so many of their radii act as one dipole.
constexpr double kFar = 2.5;

struct Term {
  double winding;
  Vec3 slope;
};

// Of a dipole at `d` from the point.
Term term(Vec3 strength, Vec3 d) {
  const double square = dot(d, d);
  if (!(square > 0)) return {0, {}};
  const double share = 1 / (4 * std::numbers::pi * (square * std::sqrt(square)));
  const double along = dot(strength, d);
  return {share * along, share * (3 * along / square * d - strength)};
}

double along(Vec3 p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

}  // namespace

WindingField::WindingField(const PointCloud& cloud, const PointIndex& index) {
  const std::size_t count = std::min(kAreaPoints + 1, cloud.points.size());
  dipoles_.reserve(cloud.points.size());
  reaches_.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Vec3 p = cloud.points[i], n = cloud.normals[i];
    const double reach = index.reach_of(p, count);
    // Those of another sheet share another disc. The last one lies on the rim.
    double sharers = 0.5;
    index.for_each_within(p, reach, [&](std::uint32_t j, double) {
      sharers += dot(cloud.normals[j], n) > 0 ? 1 : 0;
    });
    dipoles_.push_back({p, std::numbers::pi * reach * reach / sharers * n});
    reaches_.push_back(reach);
  }
  // Halving gives leaves of at most kLeafPoints at this depth.
  const std::size_t leaves = std::bit_ceil((dipoles_.size() + kLeafPoints - 1) / kLeafPoints);
  groups_.resize(2 * leaves - 1);
  build(0, dipoles_);
}

void WindingField::build(std::size_t group, std::span<Dipole> dipoles) {
  Group& g = groups_[group];
  Box3 box;
  for (const Dipole& d : dipoles) {
    const double area = length(d.strength);
    g.centre = g.centre + area * d.at;
    g.dipole = g.dipole + d.strength;
    g.area += area;
    box = box.with(d.at);
  }
  g.centre = g.area > 0 ? (1 / g.area) * g.centre : box.centre();
  for (const Dipole& d : dipoles) g.radius = std::max(g.radius, length(d.at - g.centre));
  if (2 * group + 2 >= groups_.size()) return;
  const Vec3 size = box.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::stable_sort(dipoles.begin(), dipoles.end(), [axis](const Dipole& a, const Dipole& b) {
    return along(a.at, axis) < along(b.at, axis);
  });
  const std::size_t half = dipoles.size() / 2;
  build(2 * group + 1, dipoles.first(half));
  build(2 * group + 2, dipoles.subspan(half));
}

WindingField::Value WindingField::at(Vec3 p) const {
  Value sum;
  add(0, p, dipoles_, sum);
  return sum;
}

void WindingField::add(std::size_t group, Vec3 p, std::span<const Dipole> dipoles,
                       Value& sum) const {
  const auto add_term = [&](const Term& t) {
    sum.winding += t.winding;
    sum.slope = sum.slope + t.slope;
  };
  const Group& g = groups_[group];
  if (length(p - g.centre) > kFar * g.radius) return add_term(term(g.dipole, g.centre - p));
  if (2 * group + 2 >= groups_.size()) {
    for (const Dipole& d : dipoles) add_term(term(d.strength, d.at - p));
    return;
  }
  const std::size_t half = dipoles.size() / 2;
  add(2 * group + 1, p, dipoles.first(half), sum);
  add(2 * group + 2, p, dipoles.subspan(half), sum);
}

}  // namespace slipstick
