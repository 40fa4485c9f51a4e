#include "core/solid/bsp_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/check.h"
#include "core/solid/bsp_cell.h"
#include "core/solid/mesh_model.h"

namespace slipstick {
namespace {

// Cells of at most so many polygons are split by the planes of these.
constexpr std::size_t kFew = 6;
// A plane across a cell must leave this share of the polygons on one side alone, or it is of no
// use.
constexpr double kUseful = 0.9;

struct Polygon {
  std::vector<Vec3> corners;
  BspPlane plane;
};
using Polygons = std::vector<Polygon>;

struct Split {
  BspPlane plane;
  std::size_t in_front = 0;
  std::size_t behind = 0;
  std::size_t cut = 0;
};

Split split_of(const BspPlane& plane, const Polygons& polygons) {
  Split split{plane};
  for (const Polygon& p : polygons) {
    bool front = false, back = false;
    for (const Vec3 c : p.corners) {
      const double side = side_of(plane, c);
      front = front || side > 0;
      back = back || side < 0;
    }
    split.in_front += front && !back ? 1 : 0;
    split.behind += back && !front ? 1 : 0;
    split.cut += front && back ? 1 : 0;
  }
  return split;
}

// Cuts cost as they double what is cut; the rest is balance.
double cost(const Split& s) {
  constexpr double kCut = 3;
  const auto front = static_cast<double>(s.in_front), back = static_cast<double>(s.behind);
  return kCut * static_cast<double>(s.cut) + std::abs(front - back);
}

double coordinate(Vec3 p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// Through the median of the polygons' first corners: a vertex, so that what meets it is not cut.
BspPlane across(const Polygons& polygons, int axis) {
  std::vector<double> at;
  at.reserve(polygons.size());
  for (const Polygon& p : polygons) at.push_back(coordinate(p.corners[0], axis));
  const auto median = at.begin() + static_cast<std::ptrdiff_t>(at.size() / 2);
  std::nth_element(at.begin(), median, at.end());
  return {{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}, -*median};
}

Split best_across(const Polygons& polygons) {
  Split best = split_of(across(polygons, 0), polygons);
  for (const int axis : {1, 2}) {
    const Split split = split_of(across(polygons, axis), polygons);
    if (cost(split) < cost(best)) best = split;
  }
  return best;
}

Split best_of_polygons(const Polygons& polygons) {
  constexpr std::size_t kTried = 16;
  Split best = split_of(polygons[0].plane, polygons);
  const std::size_t stride = 1 + polygons.size() / kTried;
  for (std::size_t i = stride; i < polygons.size(); i += stride) {
    const Split split = split_of(polygons[i].plane, polygons);
    if (cost(split) < cost(best)) best = split;
  }
  return best;
}

Split best_split(const Polygons& polygons) {
  if (polygons.size() > kFew) {
    const Split split = best_across(polygons);
    const auto larger = static_cast<double>(std::max(split.in_front, split.behind) + split.cut);
    if (larger < kUseful * static_cast<double>(polygons.size())) return split;
  }
  return best_of_polygons(polygons);
}

class Builder {
 public:
  Builder(const TriangleMesh& mesh, int depth_max)
      : solid_(MeshModel(mesh).placed({})), depth_max_(depth_max) {}

  // Appends the tree of a cell; what it is if it is one leaf.
  BspChild build(const BspCell& cell, Polygons polygons, int depth) {
    if (polygons.empty()) return inside(cell.middle());
    if (depth == depth_max_) {
      too_deep_ = true;
      return kBspOutside;
    }
    const Split split = best_split(polygons);
    const BspCell front_cell = cell.behind_of(flipped(split.plane));
    const BspCell back_cell = cell.behind_of(split.plane);
    auto parts = divided(polygons, split.plane);
    polygons = {};  // not held while its parts are built
    if (front_cell.empty()) return build_rest(cell, back_cell, std::move(parts.second), depth);
    if (back_cell.empty()) return build_rest(cell, front_cell, std::move(parts.first), depth);

    return append_node(
        nodes_, split.plane, [&] { return build(front_cell, std::move(parts.first), depth + 1); },
        [&] { return build(back_cell, std::move(parts.second), depth + 1); });
  }

  [[nodiscard]] bool too_deep() const { return too_deep_; }
  [[nodiscard]] std::vector<BspNode> take() { return std::move(nodes_); }

 private:
  // The plane missed the cell but for rounding: the polygons that lay in it are spent.
  BspChild build_rest(const BspCell& whole, const BspCell& part, Polygons polygons, int depth) {
    return build(part.empty() ? whole : part, std::move(polygons), depth + 1);
  }

  static std::pair<Polygons, Polygons> divided(const Polygons& polygons, const BspPlane& plane) {
    std::pair<Polygons, Polygons> parts;
    for (const Polygon& p : polygons) {
      if (p.plane == plane) continue;  // spent
      auto back = behind(p.corners, plane);
      auto front = behind(p.corners, flipped(plane));
      if (!back.empty()) parts.second.push_back({std::move(back), p.plane});
      if (!front.empty()) parts.first.push_back({std::move(front), p.plane});
    }
    return parts;
  }

  BspChild inside(Vec3 p) {
    const std::array<double, 1> x{p.x}, y{p.y};
    std::array<std::uint8_t, 1> in{};
    solid_->section(p.z)->classify(x, y, in);
    return in[0] != 0 ? kBspInside : kBspOutside;
  }

  std::shared_ptr<const Solid> solid_;
  std::vector<BspNode> nodes_;
  int depth_max_;
  bool too_deep_ = false;
};

std::optional<Polygon> polygon_of(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 across = cross(b - a, c - a);
  const double size = length(across);
  if (!(size > 0 && std::isfinite(1 / size))) return {};  // no plane: its neighbours close the gap
  const Vec3 normal = 1 / size * across;
  return Polygon{{a, b, c}, {normal, -dot(normal, a)}};
}

}  // namespace

Result<BspTree> bsp_of(const TriangleMesh& mesh, int depth_max) {
  SLIPSTICK_CHECK(depth_max > 0 && depth_max <= BspTree::kDepthMax);
  if (const std::string warning = MeshModel(mesh).warning(); !warning.empty()) {
    return fail(ErrorCode::kInput, warning);
  }
  Polygons polygons;
  Box3 box;
  for (const auto& [a, b, c] : mesh.triangles) {
    auto polygon = polygon_of(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    if (!polygon) continue;
    for (const Vec3 p : polygon->corners) box = box.with(p);
    polygons.push_back(*std::move(polygon));
  }
  if (polygons.empty()) return BspTree();
  const Vec3 size = box.size();
  constexpr double kMargin = 0.01;
  const double margin = kMargin * std::max({size.x, size.y, size.z});
  const Vec3 more{margin, margin, margin};
  Builder builder(mesh, depth_max);
  // Inside cells never reach the margin, so that the tree needs no planes for the box.
  builder.build(BspCell({box.low - more, box.high + more}), std::move(polygons), 0);
  if (builder.too_deep()) {
    return fail(ErrorCode::kInput,
                fmt::format("its tree would be deeper than {} planes: too many faces lie within "
                            "rounding of each other; print it as a mesh",
                            depth_max));
  }
  return BspTree::of(builder.take());
}

}  // namespace slipstick
