#include "core/solid/mesh_model.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "core/base/rng.h"
#include "core/image/sample.h"
#include "core/solid/mesh_model_section.h"

using namespace slipstick;

namespace {

TriangleMesh box_mesh(Vec3 size) {
  TriangleMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        {(i & 1) != 0 ? size.x : 0, (i & 2) != 0 ? size.y : 0, (i & 4) != 0 ? size.z : 0});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

// An octahedron, each triangle divided in four `times` over and blown up to the sphere of `radius`.
TriangleMesh sphere_mesh(int times, double radius) {
  TriangleMesh mesh{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int i = 0; i < times; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [entry, added] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
      if (added) mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
      return entry->second;
    };
    std::vector<TriangleMesh::Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (Vec3& p : mesh.vertices) p = (radius / length(p)) * p;
  return mesh;
}

bool inside(Section& section, Vec2 p) {
  std::uint8_t result = 0;
  section.classify({&p.x, 1}, {&p.y, 1}, {&result, 1});
  return result != 0;
}

Affine3 tilted() {
  return rotation_degrees({31, -17, 58});
}

// Every node asked on its own, with nothing narrowed.
BitImage sampled_one_by_one(const Solid& solid, double z, const SliceGrid& grid) {
  BitImage image(grid);
  const auto section = solid.section(z);
  for (int row = 1; row < grid.rows() - 1; ++row) {
    for (int column = 1; column < grid.columns() - 1; ++column) {
      image.set(column, row, inside(*section, {grid.node_x(column), grid.node_y(row)}));
    }
  }
  return image;
}

SliceGrid grid_of(const Solid& solid, double sampling) {
  const Box3 box = solid.bounds();
  return SliceGrid::over({{box.low.x, box.low.y}, {box.high.x, box.high.y}}, sampling).value();
}

}  // namespace

TEST_CASE("A box is what lies between its walls, the left and lower ones included") {
  const MeshModel model(box_mesh({3, 2, 1}));
  const auto solid = model.placed({});
  const auto section = solid->section(0.5);

  for (double x = -0.5; x <= 3.5; x += 0.25) {
    for (double y = -0.5; y <= 2.5; y += 0.25) {
      CHECK(inside(*section, {x, y}) == (x >= 0 && x < 3 && y >= 0 && y < 2));
    }
  }
}

TEST_CASE("Planes through vertices are halves of the same cut") {
  const auto solid = MeshModel(box_mesh({1, 1, 1})).placed({});

  CHECK(inside(*solid->section(0), {0.5, 0.5}));
  CHECK_FALSE(inside(*solid->section(1), {0.5, 0.5}));
  CHECK_FALSE(inside(*solid->section(-1), {0.5, 0.5}));
  CHECK_FALSE(inside(*solid->section(2), {0.5, 0.5}));
}

TEST_CASE("A tetrahedron's samples are those of its planes") {
  const auto solid = MeshModel(tetrahedron()).placed({});
  for (const double z : {0.0, 0.75, 1.0, 2.5, 3.75}) {
    const auto section = solid->section(z);
    for (double x = -0.3125; x < 5; x += 0.25) {
      for (double y = -0.375; y < 5; y += 0.25) {
        CAPTURE(x, y, z);
        CHECK(inside(*section, {x, y}) == (x >= 0 && y >= 0 && x + y + z < 4));
      }
    }
  }
}

TEST_CASE("A fine sphere is the ball but for its chords, in any pose") {
  const double radius = 5;
  const MeshModel model(sphere_mesh(5, radius));
  // Divided in 2^5, a side of an octahedron is radius*sqrt(2)/32, and blowing it up stretches it by
  // at most sqrt(3). For a point p of a triangle on the sphere, radius^2 - |p|^2 <= side^2 / 3.
  const double side = std::sqrt(6.0) * radius / 32;
  const double depth = side * side / (5.9 * radius);
  for (const Affine3& map : {Affine3{}, tilted(), rotation_degrees({90, 0, 45})}) {
    const auto solid = model.placed(map);
    for (const double z : {-4.0, -0.3, 0.0, 2.5}) {
      const auto section = solid->section(z);
      for (double x = -5.5; x < 5.5; x += 0.21) {
        for (double y = -5.5; y < 5.5; y += 0.19) {
          const double r = length(Vec3{x, y, z});
          if (r < radius - depth) CHECK(inside(*section, {x, y}));
          if (r > radius) CHECK_FALSE(inside(*section, {x, y}));
        }
      }
    }
  }
}

TEST_CASE("Every row crosses a closed mesh an even number of times") {
  const std::array<TriangleMesh, 3> meshes{box_mesh({1, 2, 3}), tetrahedron(), sphere_mesh(3, 2)};
  Rng rng(7);
  for (const TriangleMesh& mesh : meshes) {
    for (const Affine3& map : {Affine3{}, tilted(), rotation_degrees({0, 0, 45})}) {
      const auto solid = MeshModel(mesh).placed(map);
      const Box3 box = solid->bounds();
      for (int trial = 0; trial < 60; ++trial) {
        // Also heights of vertices and rows of cut points, where careless code breaks.
        const Vec3 v = map(mesh.vertices[rng.below(mesh.vertices.size())]);
        const double z = trial % 2 == 0 ? v.z : box.low.z + rng.unit() * box.size().z;
        const auto section = solid->section(z);
        auto& outline = dynamic_cast<OutlineSection&>(*section);

        CHECK(outline.crossings(v.y) % 2 == 0);
        CHECK(outline.crossings(box.low.y + rng.unit() * box.size().y) % 2 == 0);
      }
    }
  }
}

TEST_CASE("Sampling by tiles asks the same question as point by point") {
  TriangleMesh torn = sphere_mesh(3, 4);
  torn.triangles.erase(torn.triangles.begin() + 40, torn.triangles.begin() + 90);
  for (const TriangleMesh& mesh : {sphere_mesh(4, 6), box_mesh({9, 7, 5}), torn}) {
    const auto solid = MeshModel(mesh).placed(tilted());
    const SliceGrid grid = grid_of(*solid, 0.05);
    for (const double share : {0.2, 0.5, 0.77}) {
      const double z = solid->bounds().low.z + share * solid->bounds().size().z;
      const auto section = solid->section(z);

      const auto image = sample(*section, grid);

      REQUIRE(image);
      CHECK(image->any());
      CHECK(*image == sampled_one_by_one(*solid, z, grid));
    }
  }
}

TEST_CASE("A narrowed section answers as the whole one, however often it was narrowed") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    // Segments on whole coordinates, so that ends, boxes and points often meet.
    const auto whole = [&] { return static_cast<double>(rng.below(9)); };
    std::vector<OutlineSegment> segments;
    for (std::uint64_t i = 0, n = 1 + rng.below(40); i < n; ++i) {
      const double y = whole();
      segments.push_back({{whole(), y}, {whole(), y + 1 + whole()}, rng.below(2) == 0 ? 1 : -1});
    }
    const auto winding = rng.below(2) == 0 ? Winding::kNonzero : Winding::kParity;
    OutlineSection section(segments, winding);
    const Vec2 low{whole(), whole()}, size{whole(), whole()};
    const Box2 box{low, low + size}, inner{low + 0.25 * size, low + 0.75 * size};
    const auto outer = section.narrowed(box);
    const auto twice = outer.section ? outer.section->narrowed(inner) : Section::Narrowed{};

    for (int i = 0; i < 20; ++i) {
      const Vec2 p{inner.low.x + 0.125 * static_cast<double>(rng.below(5)) * size.x,
                   inner.low.y + 0.125 * static_cast<double>(rng.below(5)) * size.y};
      const bool expected = inside(section, p);

      if (outer.section) REQUIRE(inside(*outer.section, p) == expected);
      if (twice.section) REQUIRE(inside(*twice.section, p) == expected);
      for (const Cover cover : {outer.cover, twice.cover}) {
        if (cover != Cover::kMixed) REQUIRE((cover == Cover::kInside) == expected);
      }
    }
  }
}

TEST_CASE("Where no outline is near, one answer covers the box") {
  const auto solid = MeshModel(box_mesh({10, 10, 10})).placed({});
  const auto section = solid->section(5);

  CHECK(section->narrowed({{1, 1}, {9, 9}}).cover == Cover::kInside);
  CHECK(section->narrowed({{11, 1}, {12, 9}}).cover == Cover::kOutside);
  CHECK(section->narrowed({{1, 11}, {9, 12}}).cover == Cover::kOutside);
  CHECK(section->narrowed({{-2, 1}, {-1, 9}}).cover == Cover::kOutside);
  CHECK(section->narrowed({{9, 9}, {11, 11}}).cover == Cover::kMixed);
  // Level edges, which no row crosses.
  CHECK(section->narrowed({{2, -1}, {3, 0}}).cover == Cover::kMixed);
  CHECK(section->narrowed({{2, 9}, {3, 11}}).cover == Cover::kMixed);
}

TEST_CASE("A box is one even beside an open mesh, if no row changes in it") {
  TriangleMesh mesh = box_mesh({10, 10, 10});
  mesh.triangles.pop_back();
  const auto section = MeshModel(mesh).placed({})->section(5);

  const Cover covered = section->narrowed({{1, 1}, {9, 9}}).cover;
  for (const Vec2 p : {Vec2{1, 1}, Vec2{9, 1}, Vec2{5, 5}, Vec2{1, 9}, Vec2{9, 9}}) {
    if (covered != Cover::kMixed) CHECK((covered == Cover::kInside) == inside(*section, p));
  }
  CHECK(section->narrowed({{-2, 1}, {-1, 9}}).cover == Cover::kOutside);
}

TEST_CASE("Boundary edges are counted and reported") {
  TriangleMesh open = box_mesh({1, 1, 1});
  open.triangles.pop_back();
  TriangleMesh winged = box_mesh({1, 1, 1});
  winged.vertices.push_back({2, 2, 2});
  winged.triangles.push_back({0, 1, 8});

  CHECK(MeshModel(box_mesh({1, 1, 1})).open_edges() == 0);
  CHECK(MeshModel(box_mesh({1, 1, 1})).warning().empty());
  CHECK(MeshModel(open).open_edges() == 3);
  CHECK(MeshModel(open).non_manifold_edges() == 0);
  CHECK(MeshModel(open).warning() ==
        "not closed: 3 boundary edges, the inside may leak; repair the mesh or use "
        "--as ldni");
  CHECK(MeshModel(winged).open_edges() == 3);
  CHECK(MeshModel(winged).non_manifold_edges() == 1);
}

TEST_CASE("Bounds of a mesh are those of its vertices in any pose") {
  const MeshModel model(tetrahedron());
  const Affine3 map = composed(translation({1, 2, 3}), rotation_degrees({0, 0, 90}));

  CHECK(model.bounds_under(map) == Box3{{-3, 2, 3}, {1, 6, 7}});
  CHECK(model.placed(map)->bounds() == model.bounds_under(map));
  CHECK(model.kind() == "mesh");
  CHECK(model.size_text() == "4 triangles");
}

TEST_CASE("Copies of faces and faces turned round leave the solid as it was, with a warning") {
  const TriangleMesh mesh = sphere_mesh(3, 4);
  TriangleMesh doubled = mesh, flipped = mesh;
  doubled.triangles.insert(doubled.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
  std::swap(flipped.triangles[77][0], flipped.triangles[77][1]);
  const auto solid = MeshModel(mesh).placed(tilted());
  const SliceGrid grid = grid_of(*solid, 0.05);

  for (const MeshModel& model : {MeshModel(doubled), MeshModel(flipped)}) {
    CHECK_FALSE(model.warning().empty());
    for (const double z : {-3.1, 0.0, 2.7}) {
      const auto section = model.placed(tilted())->section(z);
      CHECK(*sample(*section, grid) == sampled_one_by_one(*solid, z, grid));
    }
  }
  CHECK(MeshModel(flipped).turned() == 1);
}

TEST_CASE("Overlapping shells are one solid by winding and void where they overlap by parity") {
  TriangleMesh mesh = box_mesh({2, 2, 2});
  for (const Vec3 p : box_mesh({2, 2, 2}).vertices) mesh.vertices.push_back(p + Vec3{1, 1, 0});
  for (auto [a, b, c] : box_mesh({2, 2, 2}).triangles) {
    mesh.triangles.push_back({a + 8, b + 8, c + 8});
  }
  const auto nonzero = MeshModel(mesh).placed({})->section(1);
  const auto parity = MeshModel(mesh, Winding::kParity).placed({})->section(1);

  for (const Vec2 p : {Vec2{0.5, 0.5}, Vec2{2.5, 2.5}}) {
    CHECK(inside(*nonzero, p));
    CHECK(inside(*parity, p));
  }
  CHECK(inside(*nonzero, {1.5, 1.5}));
  CHECK_FALSE(inside(*parity, {1.5, 1.5}));
  CHECK_FALSE(inside(*nonzero, {2.5, 0.5}));
}

TEST_CASE("A flat mesh has no inside") {
  const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto solid = MeshModel(flat).placed({});

  CHECK_FALSE(inside(*solid->section(0), {0.2, 0.2}));
}

TEST_CASE("A model's name says its format and stands in its errors") {
  const auto model = load_mesh_model("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "dir.ply/a.OFF");
  const auto nameless = load_mesh_model("OFF", "model");

  REQUIRE(model);
  CHECK((*model)->open_edges() == 3);
  REQUIRE_FALSE(nameless);
  CHECK(nameless.error().message == "model: \"\" is no mesh format; use stl, obj, ply, off or 3mf");
}

TEST_CASE("The interval index finds all that hold a value") {
  Rng rng(3);
  std::vector<CoordinateRange> intervals;
  for (int i = 0; i < 500; ++i) {
    const double low = rng.unit() * 10;
    const double length = i % 3 == 0 ? rng.unit() * 10 : rng.unit() * 0.1;
    intervals.push_back({low, low + (i % 7 == 0 ? 0 : length)});
  }
  const IntervalIndex index(intervals);
  std::vector<double> values{-1, 0, 5, 10, 21};
  for (const CoordinateRange& i : intervals) values.insert(values.end(), {i.low, i.high});
  for (const double value : values) {
    std::vector<int> found(intervals.size(), 0);

    index.for_each_near(value, [&](std::uint32_t i) { ++found[i]; });

    for (std::size_t i = 0; i < intervals.size(); ++i) {
      if (intervals[i].low <= value && value <= intervals[i].high) REQUIRE(found[i] == 1);
      REQUIRE(found[i] <= 1);
    }
  }
}

TEST_CASE("The Stanford bunny's middle is one piece without holes") {
  const char* folder = std::getenv("SLIPSTICK_MODELS");
  if (folder == nullptr) {
    WARN("skipped: SLIPSTICK_MODELS is not set");
    return;
  }
  std::ifstream file(std::string(folder) + "/bunny_closed_75k.ply", std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  const auto model = load_mesh_model(bytes.str(), "bunny.ply");
  REQUIRE(model);
  CHECK((*model)->size_text() == "75408 triangles");
  CHECK((*model)->warning().empty());
  const auto solid =
      (*model)->placed(composed(scaling({60, 60, 60}), rotation_degrees({90, 0, 0})));
  const SliceGrid grid = grid_of(*solid, 0.5);
  const double z = solid->bounds().low.z + 0.3 * solid->bounds().size().z;

  const auto image = sample(*solid->section(z), grid);

  REQUIRE(image);
  CHECK(*image == sampled_one_by_one(*solid, z, grid));
  // One piece without holes has Euler number 1: nodes - edges + squares.
  int euler = 0;
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const bool here = image->at(column, row), right = image->at(column + 1, row);
      const bool up = image->at(column, row + 1), across = image->at(column + 1, row + 1);
      euler += static_cast<int>(here) - static_cast<int>(here && right) -
               static_cast<int>(here && up) + static_cast<int>(here && right && up && across);
    }
  }
  CHECK(euler == 1);
}
