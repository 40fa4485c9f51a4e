#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/affine.h"
#include "core/formats/bsp_file.h"
#include "core/image/sample.h"
#include "core/solid/bsp_build.h"
#include "core/solid/bsp_merge.h"
#include "core/solid/mesh_model.h"
#include "tests/support/shapes.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

double between(Rng& rng, double low, double high) {
  return low + (high - low) * rng.unit();
}

BspPlane random_plane(Rng& rng) {
  // Some along the axes, some through lattice nodes: where values are exactly 0.
  if (rng.below(3) == 0) {
    const auto axis = rng.below(3);
    return {{axis == 0 ? 1.0 : 0.0, axis == 1 ? -1.0 : 0.0, axis == 2 ? 1.0 : 0.0},
            static_cast<double>(rng.below(9)) / 4 - 1};
  }
  return {{between(rng, -1, 1), between(rng, -1, 1), between(rng, -1, 1)}, between(rng, -1, 1)};
}

// Any planes, any leaves, in the order of a file.
BspChild grow(Rng& rng, std::vector<BspNode>& nodes, int depth) {
  if (depth == 0 || rng.below(6) == 0) return rng.below(2) == 0 ? kBspInside : kBspOutside;
  const std::size_t node = nodes.size();
  nodes.push_back({random_plane(rng)});
  const BspChild front = grow(rng, nodes, depth - 1), back = grow(rng, nodes, depth - 1);
  nodes[node].front = front;
  nodes[node].back = back;
  return static_cast<BspChild>(node);
}

BspTree box_tree(const Box3& box) {
  BspTree tree = BspTree::half_space({{-1, 0, 0}, box.low.x});
  for (const BspPlane& plane : {BspPlane{{1, 0, 0}, -box.high.x}, BspPlane{{0, -1, 0}, box.low.y},
                                BspPlane{{0, 1, 0}, -box.high.y}, BspPlane{{0, 0, -1}, box.low.z},
                                BspPlane{{0, 0, 1}, -box.high.z}}) {
    auto both = merged(tree, Boolean::kIntersection, BspTree::half_space(plane));
    REQUIRE(both);
    tree = *std::move(both);
  }
  return tree;
}

BspTree random_tree(Rng& rng) {
  std::vector<BspNode> nodes;
  while (nodes.empty()) grow(rng, nodes, 7);
  auto tree = BspTree::of(std::move(nodes));
  REQUIRE(tree);
  auto bounded = merged(*tree, Boolean::kIntersection, box_tree({{-3, -3, -3}, {3, 3, 3}}));
  REQUIRE(bounded);
  return *std::move(bounded);
}

bool contains(const BspTree& tree, Vec3 p) {
  BspChild at = tree.root();
  while (at >= 0) {
    const BspNode& node = tree.nodes()[static_cast<std::size_t>(at)];
    at = dot(node.plane.normal, p) + node.plane.offset > 0 ? node.front : node.back;
  }
  return at == kBspInside;
}

// One point at a time: what every faster way must agree with.
BitImage descended(Section& section, const SliceGrid& grid) {
  BitImage image(grid);
  std::array<double, 1> x{}, y{};
  std::array<std::uint8_t, 1> inside{};
  for (int row = 1; row < grid.rows() - 1; ++row) {
    for (int column = 1; column < grid.columns() - 1; ++column) {
      x[0] = grid.node_x(column);
      y[0] = grid.node_y(row);
      section.classify(x, y, inside);
      if (inside[0] != 0) image.set(column, row, true);
    }
  }
  return image;
}

}  // namespace

TEST_CASE("A tree that would be too deep is an error, not a guess") {
  const TriangleMesh mesh = test::mesh_of(test::shapes()[1], 12);

  const auto tree = bsp_of(mesh, 4);

  REQUIRE(!tree);
  CHECK(tree.error().code == ErrorCode::kInput);
  CHECK_THAT(tree.error().message, Catch::Contains("deeper than 4 planes"));
}

TEST_CASE("Painting a section of a tree gives the bits of descending at every node") {
  Rng rng(21);
  for (int round = 0; round < 60; ++round) {
    const auto model = BspModel::of(random_tree(rng));
    REQUIRE(model);
    const Affine3 map =
        round % 3 == 0 ? Affine3{}
                       : rotation_degrees({between(rng, 0, 360), round % 2 == 0 ? 90.0 : 33.0, 0});
    const auto solid = (*model)->placed(map);
    const auto grid = SliceGrid::over({{-4, -4}, {4, 4}}, round % 2 == 0 ? 0.25 : 0.11);
    const double z = round % 4 == 0 ? 0.5 : between(rng, -3, 3);

    BitImage painted(*grid);
    REQUIRE(solid->section(z)->paint(painted));

    CHECK(painted == descended(*solid->section(z), *grid));
  }
}

TEST_CASE("A narrowed section of a tree answers as the whole one") {
  Rng rng(22);
  for (int round = 0; round < 40; ++round) {
    const auto model = BspModel::of(random_tree(rng));
    const auto section = (*model)->placed({})->section(between(rng, -2, 2));
    const Vec2 low{between(rng, -3, 3), between(rng, -3, 3)};
    const Box2 box{low, low + Vec2{rng.unit(), rng.unit()}};
    const auto narrowed = section->narrowed(box);
    for (int i = 0; i < 50; ++i) {
      const std::vector<double> x{between(rng, box.low.x, box.high.x)};
      const std::vector<double> y{between(rng, box.low.y, box.high.y)};
      std::vector<std::uint8_t> is(1), says(1, narrowed.cover == Cover::kInside ? 1 : 0);
      section->classify(x, y, is);
      if (narrowed.section) narrowed.section->classify(x, y, says);
      if (narrowed.cover != Cover::kMixed || narrowed.section) CHECK(is == says);
    }
  }
}

TEST_CASE("Merged trees are the Boolean operation of their solids") {
  Rng rng(23);
  for (int round = 0; round < 12; ++round) {
    const BspTree a = random_tree(rng), b = random_tree(rng);
    const auto both = merged(a, Boolean::kUnion, b);
    const auto common = merged(a, Boolean::kIntersection, b);
    const auto rest = merged(a, Boolean::kDifference, b);
    REQUIRE((both && common && rest));
    for (int i = 0; i < 500; ++i) {
      const Vec3 p{between(rng, -4, 4), between(rng, -4, 4), between(rng, -4, 4)};
      const bool in_a = contains(a, p), in_b = contains(b, p);
      CHECK(contains(*both, p) == (in_a || in_b));
      CHECK(contains(*common, p) == (in_a && in_b));
      CHECK(contains(*rest, p) == (in_a && !in_b));
    }
  }
}

TEST_CASE("A tree merged with itself is itself or nothing") {
  const BspTree box = box_tree({{-1, -2, -3}, {1, 2, 3}});
  CHECK(merged(box, Boolean::kUnion, box)->nodes().size() == 6);
  CHECK(merged(box, Boolean::kDifference, box)->nodes().empty());
}

TEST_CASE("The tree of a mesh has the inside of the mesh") {
  Rng rng(24);
  for (const Shape& shape : shapes()) {
    const TriangleMesh mesh = mesh_of(shape, 9);
    const auto tree = bsp_of(mesh);
    REQUIRE(tree);
    const auto model = BspModel::of(*tree);
    REQUIRE(model);
    const Affine3 map = rotation_degrees({20, 30, 40});
    const auto solid = (*model)->placed(map);
    const auto same = MeshModel(mesh).placed(map);
    const Box3 box = same->bounds();
    CHECK(length(solid->bounds().low - box.low) < 1e-9);
    CHECK(length(solid->bounds().high - box.high) < 1e-9);
    const auto grid = SliceGrid::over({{box.low.x, box.low.y}, {box.high.x, box.high.y}}, 0.2);
    for (int i = 0; i < 3; ++i) {
      const double z = between(rng, box.low.z, box.high.z);
      INFO(shape.name << " at " << z);
      CHECK(*sample(*solid->section(z), *grid) == *sample(*same->section(z), *grid));
    }
  }
}

TEST_CASE("Flat faces of many triangles make no more cells than their planes do") {
  // A box whose faces are finely divided, turned so that no corner is a round number.
  TriangleMesh mesh = mesh_of(
      {"",
       [](Vec3 p) {
         return std::max({std::abs(p.x) - 1.003, std::abs(p.y) - 1.002, std::abs(p.z) - 1.001});
       },
       {{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}},
       {}},
      8);
  const Affine3 turned = rotation_degrees({17, 31, 47});
  for (Vec3& p : mesh.vertices) p = turned(p);
  const auto tree = bsp_of(mesh);
  REQUIRE(tree);
  CHECK(tree->nodes().size() < 4 * mesh.triangles.size());
  CHECK(BspModel::of(*tree));
}

TEST_CASE("A mesh with a hole has no tree") {
  TriangleMesh mesh = mesh_of(shapes()[0], 6);
  mesh.triangles.pop_back();
  const auto tree = bsp_of(mesh);
  REQUIRE_FALSE(tree);
  CHECK(tree.error().message.starts_with("not closed: 3 boundary edges"));
}

TEST_CASE("A tree that does not end is no solid") {
  const auto model = BspModel::of(BspTree::half_space({{0, 0, 1}, 0}));
  REQUIRE_FALSE(model);
  CHECK(model.error().message.starts_with("is not bounded"));
}

TEST_CASE("A .bsp file is read back to the bit, and any damage is told") {
  const BspTree tree = box_tree({{-1, -2, -3}, {1, 2, 3}});
  const std::string bytes = write_bsp(tree);

  const auto back = load_bsp_model(bytes, "a.bsp");

  REQUIRE(back);
  CHECK(std::equal(tree.nodes().begin(), tree.nodes().end(), (*back)->tree().nodes().begin()));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    CHECK_FALSE(load_bsp_model(damaged, "a.bsp"));
    CHECK_FALSE(load_bsp_model(bytes.substr(0, i), "a.bsp"));
  }
}

TEST_CASE("Nodes that are no tree are refused by their number") {
  const BspPlane plane{{1, 0, 0}, 0};
  const auto error = [](std::vector<BspNode> nodes) {
    const auto tree = BspTree::of(std::move(nodes));
    REQUIRE_FALSE(tree);
    return tree.error().message;
  };
  CHECK(error({{plane, 0, kBspInside}}).starts_with("node 0 has no such child"));
  CHECK(error({{plane, 1, 1}, {plane}}).starts_with("node 0 shares a child"));
  CHECK(error({{plane}, {plane}}).starts_with("node 1 is nobody's child"));
  CHECK(error({{{{0, 0, 0}, 1}}}).starts_with("node 0 has no plane"));
  CHECK(error({{{{NAN, 0, 0}, 1}}}).starts_with("node 0 has no plane"));
  std::vector<BspNode> deep;
  for (BspChild i = 0; i <= BspTree::kDepthMax; ++i) deep.push_back({plane, kBspOutside, i + 1});
  deep.back().back = kBspInside;
  CHECK(error(deep).starts_with("node 512 lies too deep"));
}
