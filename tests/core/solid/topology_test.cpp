#include <array>
#include <memory>

#include "core/solid/bsp_build.h"
#include "core/solid/bsp_model.h"
#include "core/solid/mesh_model.h"
#include "core/solid/rbf_fit.h"
#include "tests/support/shapes.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

constexpr std::array<Vec3, 5> kDirections{
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {1, 1, 1}, {-0.3, 0.5, 0.7}}};
// Half of the thinnest wall and gap of the shapes, and a little less.
constexpr double kWidth = 0.25;

void check(const Model& model, const Shape& shape) {
  for (const Vec3 direction : kDirections) {
    INFO(shape.name << " as " << model.kind() << " along " << direction.x << ' ' << direction.y
                    << ' ' << direction.z);
    const Betti found = betti_of(sliced(model, direction, kWidth));
    CHECK(found.components == shape.betti.components);
    CHECK(found.tunnels == shape.betti.tunnels);
    CHECK(found.cavities == shape.betti.cavities);
  }
}

}  // namespace

TEST_CASE("Slices of a mesh and of its tree have its components, tunnels and cavities") {
  for (const Shape& shape : shapes()) {
    const TriangleMesh mesh = mesh_of(shape, 24);
    check(MeshModel(mesh), shape);
    auto tree = bsp_of(mesh);
    REQUIRE(tree);
    check(**BspModel::of(*std::move(tree)), shape);
  }
}

TEST_CASE("Slices of a fit have the components, tunnels and cavities of the points' solid") {
  for (const Shape& shape : shapes()) {
    Rng rng(31);
    const auto fit = fit_rbf(cloud_of(shape, 4000, rng));
    REQUIRE(fit);
    check(*fit->model, shape);
  }
}
