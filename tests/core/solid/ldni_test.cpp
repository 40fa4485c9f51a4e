#include <array>
#include <cmath>

#include "core/image/sample.h"
#include "core/solid/ldni_boolean.h"
#include "core/solid/ldni_build.h"
#include "core/solid/ldni_model.h"
#include "core/solid/ldni_sample.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

constexpr int kResolution = 48;

MeshModel mesh_model(const Shape& shape) {
  return MeshModel(mesh_of(shape, 16));
}

LdniOfMesh images_of(const MeshModel& mesh, int resolution = kResolution) {
  const auto grid = LdniGrid::around(mesh.bounds_under({}), resolution);
  REQUIRE(grid);
  auto made = ldni_of(mesh, *grid);
  REQUIRE(made);
  return *std::move(made);
}

bool inside(const Solid& solid, Vec3 p) {
  std::uint8_t result = 0;
  solid.section(p.z)->classify({&p.x, 1}, {&p.y, 1}, {&result, 1});
  return result != 0;
}

Vec3 random_point(Rng& rng, const Box3& box) {
  const Vec3 size = box.size();
  return box.low + Vec3{rng.unit() * size.x, rng.unit() * size.y, rng.unit() * size.z};
}

}  // namespace

TEST_CASE("Away from the surface an image has the memberships of its mesh, whichever way it lies") {
  Rng rng(3);
  for (const Shape& shape : shapes()) {
    const MeshModel mesh = mesh_model(shape);
    const LdniModel images(images_of(mesh).ldni);
    const double width = images.ldni().grid().width();
    const double off = std::sqrt(2 + 1.6 * 1.6) * width;  // what ldni_sight.h promises
    for (const Vec3 angles : {Vec3{0, 0, 0}, Vec3{90, 0, 180}, Vec3{31, -17, 58}}) {
      const Affine3 map = rotation_degrees(angles);
      const auto exact = mesh.placed(map), solid = images.placed(map);
      int compared = 0;
      for (int i = 0; i < 120; ++i) {
        const Vec3 p = random_point(rng, solid->bounds());
        const bool here = inside(*exact, p);
        // No membership changes around the point: probes in 14 directions, since the mesh is
        // smooth at this scale.
        bool near = false;
        for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{.58, .58, .58},
                             Vec3{-.58, .58, .58}, Vec3{.58, -.58, .58}, Vec3{.58, .58, -.58}}) {
          for (const double step : {-1.5, -0.75, 0.75, 1.5}) {
            near = near || inside(*exact, p + step * off * d) != here;
          }
        }
        if (near) continue;
        ++compared;
        INFO(shape.name << ' ' << p.x << ' ' << p.y << ' ' << p.z);
        REQUIRE(inside(*solid, p) == here);
      }
      CHECK(compared > 15);
    }
  }
}

TEST_CASE("A smooth surface is off by the square of the width, not by the width") {
  const Shape ball = shapes().front();
  REQUIRE(ball.name == "sphere");
  // Faces of the mesh are 0.2 long, so that it is a ball to 0.2²/(8·4).
  const MeshModel mesh(mesh_of(ball, 46));
  Rng rng(5);
  for (const int resolution : {40, 80}) {
    const LdniModel images(images_of(mesh, resolution).ldni);
    const double width = images.ldni().grid().width();
    const auto solid = images.placed({});
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
      Vec3 p = random_point(rng, {{-1, -1, -1}, {1, 1, 1}});
      p = 1 / length(p) * p;
      // Along the radius, between a width inside and a width outside.
      double in = 4 - width, out = 4 + width;
      REQUIRE(inside(*solid, in * p));
      REQUIRE(!inside(*solid, out * p));
      for (int k = 0; k < 12; ++k) {
        const double middle = 0.5 * (in + out);
        (inside(*solid, middle * p) ? in : out) = middle;
      }
      worst = std::max(worst, std::abs(0.5 * (in + out) - 4));
    }
    // A tangent plane is off by half the squared distance from its point, 2.14 widths, times the
    // curvature; the facets add their own, and their normals turn by half of 0.2/4 across.
    const double bound = 0.5 * 2.14 * 2.14 * width * width / 4 + 0.00125 + 0.025 * width;
    CAPTURE(resolution, width, worst, bound);
    CHECK(worst < bound);
  }
}

TEST_CASE("Images sampled from a solid are those of its mesh to a tenth of a width") {
  const Shape ball = shapes().front();
  // Faces of the mesh are 0.1 long: it is a ball to 0.0003.
  const MeshModel mesh(mesh_of(ball, 92));
  const auto grid = LdniGrid::around(mesh.bounds_under({}), 40);
  REQUIRE(grid);
  const auto sampled = ldni_by_sampling(BallModel(4), *grid);
  REQUIRE(sampled);
  const Ldni exact = ldni_of(mesh, *grid)->ldni;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t ray = 0; ray < grid->rays(); ++ray) {
      const auto a = sampled->axes()[axis].of(ray), b = exact.axes()[axis].of(ray);
      // A glancing ray may lie between nodes, or meet only one of them.
      if (a.empty() || b.empty()) continue;
      REQUIRE(a.size() == b.size());
      const double length = (b[1].depth - b[0].depth) / double{LdniGrid::kUnits};
      if (length < 2) continue;
      for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::abs(double(a[k].depth) - double(b[k].depth)) < 0.1 * LdniGrid::kUnits);
      }
    }
  }
  const auto refused = ldni_by_sampling(BallModel(40), *grid);
  REQUIRE(!refused);
  CHECK(refused.error().message.find("out of the grid") != std::string::npos);
}

TEST_CASE("An image of a layer is the same bit for bit as if every node had been asked") {
  Rng rng(9);
  for (const Shape& shape : shapes()) {
    const LdniModel images(images_of(mesh_model(shape)).ldni);
    const auto solid =
        images.placed(rotation_degrees({40 * rng.unit(), 40 * rng.unit(), 90 * rng.unit()}));
    const Box3 b = solid->bounds();
    const auto grid = SliceGrid::over({{b.low.x, b.low.y}, {b.high.x, b.high.y}}, 0.11);
    REQUIRE(grid);
    for (const double share : {0.15, 0.5, 0.83}) {
      const double z = b.low.z + share * b.size().z;
      const auto image = sample(*solid->section(z), *grid);
      REQUIRE(image);
      int different = 0;
      for (int row = 1; row < grid->rows() - 1; ++row) {
        for (int column = 1; column < grid->columns() - 1; ++column) {
          const bool here = inside(*solid, {grid->node_x(column), grid->node_y(row), z});
          different += image->at(column, row) == here ? 0 : 1;
        }
      }
      INFO(shape.name << " at " << z);
      CHECK(different == 0);
    }
  }
}

TEST_CASE(
    "A mesh, its copy with all faces doubled and one with a face turned have the same images") {
  for (const Shape& shape : shapes()) {
    const TriangleMesh mesh = mesh_of(shape, 12);
    const Ldni plain = images_of(MeshModel(mesh)).ldni;
    TriangleMesh doubled = mesh;
    doubled.triangles.insert(doubled.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    TriangleMesh turned = mesh;
    std::swap(turned.triangles[7][0], turned.triangles[7][1]);
    INFO(shape.name);
    for (const TriangleMesh& other : {doubled, turned}) {
      const Ldni same = images_of(MeshModel(other)).ldni;
      CHECK(same == plain);
    }
  }
}

TEST_CASE("Rays through corners, edges and faces are like others") {
  // A cube whose corners, edges and faces all lie on rays of the grid.
  TriangleMesh cube;
  for (unsigned i = 0; i < 8; ++i) {
    cube.vertices.push_back({i & 1u ? 6.0 : 2.0, i & 2u ? 6.0 : 2.0, i & 4u ? 6.0 : 2.0});
  }
  cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const auto grid = LdniGrid::of(9, 1, {0, 0, 0});
  REQUIRE(grid);
  const auto made = ldni_of(MeshModel(cube), *grid);
  REQUIRE(made);
  CHECK(made->mended == LdniMended{});
  for (const LdniRays& rays : made->ldni.axes()) {
    for (int j = 0; j < 9; ++j) {
      for (int i = 0; i < 9; ++i) {
        // Half open: the lower faces count, the upper ones do not.
        const bool meets = i >= 2 && i < 6 && j >= 2 && j < 6;
        const auto samples = rays.of(grid->ray(i, j));
        REQUIRE(samples.size() == (meets ? 2 : 0));
        if (!meets) continue;
        CHECK(samples[0].depth == 2 * LdniGrid::kUnits);
        CHECK(samples[1].depth == 6 * LdniGrid::kUnits);
      }
    }
  }
}

TEST_CASE("Behind a crack rays are taken from their neighbours, and counted") {
  const Shape ball = shapes().front();
  TriangleMesh cracked = mesh_of(ball, 40);
  const Ldni whole = images_of(MeshModel(cracked)).ldni;
  const std::size_t faces = cracked.triangles.size();
  // Each crack is one triangle, as wide as about one ray.
  for (std::size_t i = 0; i < 12; ++i) {
    cracked.triangles.erase(cracked.triangles.begin() +
                            static_cast<std::ptrdiff_t>(i * (faces / 13)));
  }
  const LdniOfMesh made = images_of(MeshModel(cracked));
  CHECK(made.mended.copied > 0);
  CHECK(made.mended.lost == 0);
  const LdniModel with(made.ldni), without(whole);
  const auto a = with.placed({}), b = without.placed({});
  Rng rng(1);
  int different = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = random_point(rng, b->bounds());
    const double off = std::abs(ball.f(p)) / whole.grid().width();
    if (inside(*a, p) != inside(*b, p) && off > 1) ++different;
  }
  CHECK(different == 0);
}

TEST_CASE("Boolean operations on rays are those on points, and undo each other") {
  const auto grid = LdniGrid::of(40, 0.4, {-8, -8, -8});
  REQUIRE(grid);
  const auto moved = [&](std::size_t which, Vec3 by) {
    TriangleMesh mesh = mesh_of(shapes()[which], 14);
    for (Vec3& p : mesh.vertices) p = p + by;
    auto made = ldni_of(MeshModel(std::move(mesh)), *grid);
    REQUIRE(made);
    return made->ldni;
  };
  const auto on_ray = [](std::span<const LdniSample> ray, std::uint32_t depth) {
    std::size_t before = 0;
    while (before < ray.size() && ray[before].depth <= depth) ++before;
    return before % 2 != 0;
  };
  const Ldni a = moved(0, {-1, 0.5, 0}), b = moved(1, {1, 0, 0.7});
  const auto both = merged(a, Boolean::kIntersection, b), either = merged(a, Boolean::kUnion, b),
             rest = merged(a, Boolean::kDifference, b);
  REQUIRE((both && either && rest));
  Rng rng(4);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 3000; ++i) {
      const std::size_t ray = rng.below(static_cast<std::uint32_t>(grid->rays()));
      const auto depth =
          static_cast<std::uint32_t>(rng.unit() * static_cast<double>(grid->depth_end() - 1));
      const bool in_a = on_ray(a.axes()[axis].of(ray), depth);
      const bool in_b = on_ray(b.axes()[axis].of(ray), depth);
      REQUIRE(on_ray(both->axes()[axis].of(ray), depth) == (in_a && in_b));
      REQUIRE(on_ray(either->axes()[axis].of(ray), depth) == (in_a || in_b));
      REQUIRE(on_ray(rest->axes()[axis].of(ray), depth) == (in_a && !in_b));
    }
  }
  CHECK(*merged(*rest, Boolean::kUnion, *both) == a);
  CHECK(merged(a, Boolean::kDifference, a)->samples() == 0);
  CHECK(*merged(a, Boolean::kUnion, a) == a);
  const auto other = LdniGrid::of(40, 0.5, {-8, -8, -8});
  const auto elsewhere = Ldni::of(*other, [&] {
    LdniAxes axes;
    for (LdniRays& rays : axes) rays.first.assign(other->rays() + 1, 0);
    return axes;
  }());
  REQUIRE(elsewhere);
  const auto refused = merged(a, Boolean::kUnion, *elsewhere);
  REQUIRE(!refused);
  CHECK(refused.error().message.find("one grid") != std::string::npos);
}

TEST_CASE("What is no grid, no normal and no image is refused") {
  const double nan = std::nan("");
  CHECK(!LdniGrid::of(1, 1, {}));
  CHECK(!LdniGrid::of(4096, 1, {}));
  CHECK(!LdniGrid::of(8, 0, {}));
  CHECK(!LdniGrid::of(8, nan, {}));
  CHECK(!LdniGrid::of(8, 1, {0, nan, 0}));
  CHECK(!LdniGrid::of(8, 1, {0, 0, -2e9}));
  CHECK(!LdniGrid::around({}, 100));
  CHECK(!LdniNormal::of({0, 0, 0}));
  CHECK(!LdniNormal::of({1, nan, 0}));
  CHECK(!LdniNormal::from_word(0));
  CHECK(LdniNormal::from_word(LdniNormal::of({1, -2, 0.5})->word()) == LdniNormal::of({2, -4, 1}));

  const auto grid = LdniGrid::of(2, 1, {});
  REQUIRE(grid);
  const auto with_first_ray = [&](std::vector<std::uint32_t> depths) {
    LdniAxes axes;
    for (LdniRays& rays : axes) rays.first.assign(grid->rays() + 1, 0);
    for (const std::uint32_t depth : depths) axes[1].samples.push_back({depth, {}});
    for (std::size_t ray = 1; ray <= grid->rays(); ++ray) {
      axes[1].first[ray] = static_cast<std::uint32_t>(depths.size());
    }
    return Ldni::of(*grid, std::move(axes));
  };
  CHECK(with_first_ray({}));
  CHECK(with_first_ray({1, 2}));
  CHECK(!with_first_ray({1}));
  CHECK(!with_first_ray({2, 1}));
  CHECK(!with_first_ray({1, 1}));
  CHECK(!with_first_ray({1, 2 * LdniGrid::kUnits}));
  CHECK(with_first_ray({1, 2 * LdniGrid::kUnits - 1}));
}
