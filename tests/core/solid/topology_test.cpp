#include <array>
#include <cstdlib>
#include <memory>
#include <span>

#include "core/solid/bsp_build.h"
#include "core/solid/bsp_model.h"
#include "core/solid/ldni_build.h"
#include "core/solid/ldni_model.h"
#include "core/solid/mesh_model.h"
#include "core/solid/rbf_fit.h"
#include "tests/support/shapes.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

constexpr std::array<Vec3, 5> kDirections{
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {1, 1, 1}, {-0.3, 0.5, 0.7}}};
constexpr double kWidth = 0.25;

void check(const Model& model, const Shape& shape, std::span<const Vec3> directions) {
  for (const Vec3 direction : directions) {
    INFO(shape.name << " as " << model.kind() << " along " << direction.x << ' ' << direction.y
                    << ' ' << direction.z);
    const Betti found = betti_of(sliced(model, direction, kWidth));
    CHECK(found.components == shape.betti.components);
    CHECK(found.tunnels == shape.betti.tunnels);
    CHECK(found.cavities == shape.betti.cavities);
  }
}

// One direction for each shape; all five of them with SLIPSTICK_TOPOLOGY=all, which takes minutes
// under sanitizers.
std::span<const Vec3> directions_of(std::size_t shape) {
  const std::span<const Vec3> directions(kDirections);
  return std::getenv("SLIPSTICK_TOPOLOGY") != nullptr ? directions
                                                      : directions.subspan(shape % 5, 1);
}

}  // namespace

TEST_CASE("Slices of a mesh and of its tree have its components, tunnels and cavities") {
  std::size_t which = 0;
  for (const Shape& shape : shapes()) {
    const TriangleMesh mesh = mesh_of(shape, 16);
    check(MeshModel(mesh), shape, std::span(kDirections).first(1));
    auto tree = bsp_of(mesh);
    REQUIRE(tree);
    check(**BspModel::of(*std::move(tree)), shape, directions_of(which++));
  }
}

TEST_CASE(
    "Slices of layered depth-normal images have the mesh's components, tunnels and cavities") {
  for (const Shape& shape : shapes()) {
    const MeshModel mesh(mesh_of(shape, 16));
    // As the paper has it, rays stand closer than nodes.
    const auto grid = LdniGrid::around(mesh.bounds_under({}), 96);
    REQUIRE(grid);
    auto images = ldni_of(mesh, *grid);
    REQUIRE(images);
    check(LdniModel(std::move(images->ldni)), shape, kDirections);
  }
}

TEST_CASE("Slices of a fit have the components, tunnels and cavities of the points' solid") {
  std::size_t which = 0;
  for (const Shape& shape : shapes()) {
    const std::size_t points = shape.name == "gyroid" ? 8000 : 2000;
    Rng rng(31);
    const auto fit = fit_rbf(cloud_of(shape, points, rng));
    REQUIRE(fit);
    check(*fit->model, shape, directions_of(which++));
  }
}
