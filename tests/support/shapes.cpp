#include "tests/support/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/check.h"
#include "core/image/sample.h"
#include "core/job/placement.h"

namespace slipstick::test {
namespace {

double torus(Vec3 p, double large, double small) {
  const double ring = std::sqrt(p.x * p.x + p.y * p.y) - large;
  return std::sqrt(ring * ring + p.z * p.z) - small;
}

// The larger of the two, its edges rounded to about `radius`.
double rounded_max(double a, double b, double radius) {
  const double u = std::max(a + radius, 0.0), v = std::max(b + radius, 0.0);
  return std::min(std::max(a, b), -radius) + std::sqrt(u * u + v * v);
}

double tunnelled_box(Vec3 p) {
  constexpr double kRadius = 0.6;
  const double side = rounded_max(rounded_max(std::abs(p.x) - 5, std::abs(p.y) - 4, kRadius),
                                  std::abs(p.z) - 3, kRadius);
  return rounded_max(side, 1.7 - std::sqrt(p.x * p.x + p.y * p.y), kRadius);
}

// One side of the surface within a ball. Its two tunnels are what the Euler number of the function
// says on lattices from 0.25 to 0.04 wide.
double gyroid(Vec3 p) {
  const double wave =
      std::sin(p.x) * std::cos(p.y) + std::sin(p.y) * std::cos(p.z) + std::sin(p.z) * std::cos(p.x);
  return rounded_max(wave / 1.5, length(p) - 4.3, 0.4);
}

Box3 cube(double half) {
  return {{-half, -half, -half}, {half, half, half}};
}

Vec3 gradient(const Shape& shape, Vec3 p) {
  constexpr double kStep = 1e-5;
  const auto slope = [&](Vec3 d) {
    return (shape.f(p + kStep * d) - shape.f(p - kStep * d)) / (2 * kStep);
  };
  return {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
}

// One vertex an edge of the lattice of tetrahedra.
class Marching {
 public:
  Marching(const Shape& shape, double h) : shape_(shape), h_(h) {
    const Vec3 size = shape.box.size();
    const auto cells = [&](double side) { return static_cast<int>(std::ceil(side / h)); };
    nx_ = cells(size.x);
    ny_ = cells(size.y);
    nz_ = cells(size.z);
    for (int z = 0; z <= nz_; ++z) {
      for (int y = 0; y <= ny_; ++y) {
        for (int x = 0; x <= nx_; ++x) values_.push_back(shape.f(at({x, y, z})));
      }
    }
  }

  TriangleMesh made() {
    // Kuhn's six tetrahedra of a cube: a way along the three axes in each order.
    constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    for (int z = 0; z < nz_; ++z) {
      for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
          for (const auto& order : kOrders) tetrahedron({x, y, z}, order);
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  using Node = std::array<int, 3>;

  Vec3 at(Node n) const { return shape_.box.low + h_ * Vec3{n[0] * 1.0, n[1] * 1.0, n[2] * 1.0}; }
  std::size_t number(Node n) const {
    return static_cast<std::size_t>((n[2] * (ny_ + 1) + n[1]) * (nx_ + 1) + n[0]);
  }
  double value(Node n) const { return values_[number(n)]; }

  void tetrahedron(Node node, const std::array<int, 3>& order) {
    std::array<Node, 4> corners{node, node, node, node};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = i + 1; k < 4; ++k) ++corners[k][static_cast<std::size_t>(order[i])];
    }
    std::vector<Node> in, out;
    for (const Node& c : corners) (value(c) <= 0 ? in : out).push_back(c);
    if (in.size() == 1 || out.size() == 1) {
      const auto& lone = in.size() == 1 ? in : out;
      const auto& rest = in.size() == 1 ? out : in;
      add(vertex(lone[0], rest[0]), vertex(lone[0], rest[1]), vertex(lone[0], rest[2]), in[0],
          out[0]);
    } else if (in.size() == 2) {
      const auto a = vertex(in[0], out[0]), b = vertex(in[0], out[1]), c = vertex(in[1], out[1]),
                 d = vertex(in[1], out[0]);
      add(a, b, c, in[0], out[0]);
      add(a, c, d, in[0], out[0]);
    }
  }

  std::uint32_t vertex(Node a, Node b) {
    const std::pair<std::size_t, std::size_t> key = std::minmax(number(a), number(b));
    const auto [found, is_new] =
        vertices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      // Kept off the ends, so that no two vertices meet.
      const double share = std::clamp(value(a) / (value(a) - value(b)), 0.02, 0.98);
      mesh_.vertices.push_back(at(a) + share * (at(b) - at(a)));
    }
    return found->second;
  }

  // Turned so that it faces from `in` to `out`.
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, Node in, Node out) {
    const Vec3 p = mesh_.vertices[a];
    const Vec3 normal = cross(mesh_.vertices[b] - p, mesh_.vertices[c] - p);
    const bool outwards = dot(normal, at(out) - p) - dot(normal, at(in) - p) > 0;
    mesh_.triangles.push_back(outwards ? TriangleMesh::Triangle{a, b, c}
                                       : TriangleMesh::Triangle{a, c, b});
  }

  const Shape& shape_;
  double h_;
  int nx_ = 0;
  int ny_ = 0;
  int nz_ = 0;
  std::vector<double> values_;
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> vertices_;
  TriangleMesh mesh_;
};

}  // namespace

std::vector<Shape> shapes() {
  return {
      {"sphere", [](Vec3 p) { return length(p) - 4; }, cube(4.6), {1, 0, 0}},
      {"torus",
       [](Vec3 p) { return torus(p, 4, 1.6); },
       {{-6.2, -6.2, -2.2}, {6.2, 6.2, 2.2}},
       {1, 1, 0}},
      {"linked tori",
       [](Vec3 p) {
         return std::min(torus(p, 4, 1.2), torus({p.x - 4, p.z, p.y}, 4, 1.2));
       },
       {{-5.8, -5.8, -5.8}, {9.8, 5.8, 5.8}},
       {2, 2, 0}},
      {"box with tunnel", tunnelled_box, {{-5.7, -4.7, -3.7}, {5.7, 4.7, 3.7}}, {1, 1, 0}},
      {"hollow sphere", [](Vec3 p) { return std::abs(length(p) - 3.5) - 1; }, cube(5.1), {1, 0, 1}},
      {"gyroid", gyroid, cube(4.9), {1, 2, 0}}};
}

PointCloud cloud_of(const Shape& shape, std::size_t count, Rng& rng) {
  PointCloud cloud;
  const Vec3 size = shape.box.size();
  while (cloud.points.size() < count) {
    Vec3 p = shape.box.low + Vec3{rng.unit() * size.x, rng.unit() * size.y, rng.unit() * size.z};
    // Far points would all come to rest on the same convex parts.
    if (std::abs(shape.f(p)) > 0.5) continue;
    for (int round = 0; round < 20; ++round) {
      const Vec3 g = gradient(shape, p);
      const double square = dot(g, g);
      if (square > 1e-6) p = p - shape.f(p) / square * g;
    }
    const Vec3 g = gradient(shape, p);
    if (std::abs(shape.f(p)) > 1e-9 || length(g) < 1e-3) continue;
    cloud.points.push_back(p);
    cloud.normals.push_back(1 / length(g) * g);
  }
  return cloud;
}

TriangleMesh mesh_of(const Shape& shape, int cells) {
  const Vec3 size = shape.box.size();
  return Marching(shape, std::max({size.x, size.y, size.z}) / cells).made();
}

std::vector<BitImage> sliced(const Model& model, Vec3 direction, double h) {
  PlacementRequest request;
  request.direction = direction;
  const auto placed = place_on_bed(model, request, {0, 0});
  SLIPSTICK_CHECK(placed.has_value());
  const Box3& b = placed->bounds;
  const auto grid = SliceGrid::over({{b.low.x, b.low.y}, {b.high.x, b.high.y}}, h);
  SLIPSTICK_CHECK(grid.has_value());
  std::vector<BitImage> stack;
  for (int layer = 0; (layer + 0.5) * h < b.high.z; ++layer) {
    auto image = sample(*placed->solid->section((layer + 0.5) * h), *grid);
    SLIPSTICK_CHECK(image.has_value());
    stack.push_back(*std::move(image));
  }
  return stack;
}

}  // namespace slipstick::test
