#include "core/formats/rbf_file.h"
#include "core/image/sample.h"
#include "core/solid/rbf_field.h"
#include "core/solid/rbf_fit.h"
#include "core/solid/rbf_points.h"
#include "tests/support/shapes.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

double between(Rng& rng, double low, double high) {
  return low + (high - low) * rng.unit();
}

// Balls of all sizes with any quadrics: nothing like a fit, so bounds must earn their keep.
std::unique_ptr<RbfModel> random_model(Rng& rng, int count) {
  std::vector<RbfFunction> functions;
  for (int i = 0; i < count; ++i) {
    RbfFunction f;
    f.centre = {between(rng, -3, 3), between(rng, -3, 3), between(rng, -3, 3)};
    f.radius = between(rng, 0.2, 2);
    for (double& c : f.quadric) c = between(rng, -1, 1);
    functions.push_back(f);
  }
  auto model = RbfModel::of(std::move(functions));
  REQUIRE(model);
  return *std::move(model);
}

Affine3 random_map(Rng& rng) {
  const Affine3 turned =
      rotation_degrees({between(rng, -180, 180), between(rng, -180, 180), between(rng, -180, 180)});
  return composed(turned, scaling({between(rng, 0.5, 2), between(rng, 0.5, 2), 1}));
}

const PointCloud& ball_cloud() {
  static const PointCloud cloud = [] {
    Rng rng(1);
    return cloud_of(shapes()[0], 700, rng);
  }();
  return cloud;
}

}  // namespace

TEST_CASE("Painting an RBF solid gives the bits of asking point by point") {
  Rng rng(7);
  for (int round = 0; round < 12; ++round) {
    const auto model = random_model(rng, 1 + round * 3);
    const Affine3 map = random_map(rng);
    const auto solid = model->placed(map);
    const auto grid = SliceGrid::over({{-7, -7}, {7, 7}}, 0.25);
    const double z = between(rng, -3, 3);

    const auto image = sample(*solid->section(z), *grid);

    REQUIRE(image);
    const Affine3 back = inverse(map);
    std::size_t wrong = 0;
    for (int row = 1; row < grid->rows() - 1; ++row) {
      for (int column = 1; column < grid->columns() - 1; ++column) {
        const Vec3 p = back({grid->node_x(column), grid->node_y(row), z});
        wrong += rbf_inside(model->functions(), p) != image->at(column, row) ? 1U : 0U;
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("The value of an RBF solid is at most 0 exactly where it is inside") {
  Rng rng(8);
  const auto model = random_model(rng, 30);
  const auto section = model->placed({})->section(0.3);
  std::vector<double> xs, ys;
  for (int i = 0; i < 2000; ++i) {
    xs.push_back(between(rng, -6, 6));
    ys.push_back(between(rng, -6, 6));
  }
  std::vector<double> values(xs.size());
  std::vector<std::uint8_t> inside(xs.size());

  REQUIRE(section->evaluate(xs, ys, values));
  section->classify(xs, ys, inside);

  for (std::size_t i = 0; i < xs.size(); ++i) CHECK((values[i] <= 0) == (inside[i] != 0));
}

TEST_CASE("The bounds of an RBF solid are tight") {
  Rng rng(9);
  const auto fit = fit_rbf(ball_cloud());
  REQUIRE(fit);
  for (int round = 0; round < 1; ++round) {
    const Affine3 map = rotation_degrees({between(rng, 0, 90), between(rng, 0, 90), 30});
    const Vec3 size = fit->model->bounds_under(map).size();
    for (const double side : {size.x, size.y, size.z}) {
      // Between the random points the fit is a little off.
      CHECK(side > 7.95);
      CHECK(side < 8.25);
    }
  }
}

TEST_CASE("The bounds of an RBF solid hold all of it") {
  Rng rng(13);
  for (int round = 0; round < 6; ++round) {
    const auto model = random_model(rng, 1 + 4 * round);
    const Affine3 map = random_map(rng);
    const Box3 box = model->bounds_under(map);
    std::size_t beyond = 0;
    for (int i = 0; i < 5000; ++i) {
      const Vec3 p{between(rng, -5, 5), between(rng, -5, 5), between(rng, -5, 5)};
      const Vec3 q = map(p);
      if (rbf_inside(model->functions(), p)) beyond += box.with(q) == box ? 0U : 1U;
    }
    CHECK(beyond == 0);
  }
}

TEST_CASE("A fit passes through its points and fills its inside, and there are no phantoms") {
  for (const std::size_t which : {0U, 1U, 4U}) {
    Rng rng(10 + which);
    const Shape shape = shapes()[which];
    const PointCloud cloud = which == 0 ? ball_cloud() : cloud_of(shape, 1500, rng);

    const auto fit = fit_rbf(cloud);

    INFO(shape.name << ": " << fit->surface_functions << " and " << fit->fill_functions);
    REQUIRE(fit);
    CHECK(fit->mean_value < 1e-4 * fit->diagonal);
    const auto& functions = fit->model->functions();
    // Random points have gaps of several spacings; within one spacing of the surface anything is
    // right.
    const double near = 0.4;
    std::size_t phantoms = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p{between(rng, -8, 8), between(rng, -8, 8), between(rng, -8, 8)};
      if (std::abs(shape.f(p)) < near) continue;
      phantoms += rbf_inside(functions, p) != (shape.f(p) < 0) ? 1U : 0U;
    }
    CHECK(phantoms == 0);
  }
}

TEST_CASE("What no support holds is outside") {
  RbfFunction inside;
  inside.quadric[0] = -1;
  const auto model = RbfModel::of({inside});
  const auto section = (*model)->placed({})->section(0);
  std::vector<double> xs{0.999, 1.001}, ys{0, 0}, values(2);

  REQUIRE(section->evaluate(xs, ys, values));

  CHECK(values[0] == -1);
  CHECK(values[1] > 0);
}

TEST_CASE("The same points give the same bytes") {
  const auto once = fit_rbf(ball_cloud());
  const auto again = fit_rbf(ball_cloud());
  CHECK(write_rbf(*once->model) == write_rbf(*again->model));
}

TEST_CASE("Points on a line, in a plane, twice the same or at random are fitted without harm") {
  Rng rng(11);
  for (int kind = 0; kind < 4; ++kind) {
    PointCloud cloud;
    for (int i = 0; i < 30; ++i) {
      const double t = between(rng, 0, 1), u = between(rng, 0, 1);
      const Vec3 p = kind == 0   ? Vec3{t, 2 * t, 3 * t}
                     : kind == 1 ? Vec3{t, u, 0}
                     : kind == 2 ? Vec3{i < 15 ? 0.0 : 1.0, 0, 0}
                                 : Vec3{t, u, between(rng, 0, 1)};
      cloud.points.push_back(p);
      const Vec3 n{between(rng, -1, 1), between(rng, -1, 1), between(rng, -1, 1)};
      cloud.normals.push_back(1 / length(n) * n);
    }
    const auto fit = fit_rbf(cloud);
    if (fit) CHECK(fit->model->bounds_under({}).size().x < 10);
  }
}

TEST_CASE("An .rbf file is read back to the bit, and any damage is told") {
  Rng rng(12);
  const auto model = random_model(rng, 3);
  const std::string bytes = write_rbf(*model);

  const auto back = load_rbf_model(bytes, "a.rbf");

  REQUIRE(back);
  CHECK((*back)->functions() == model->functions());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    CHECK_FALSE(load_rbf_model(damaged, "a.rbf"));
    CHECK_FALSE(load_rbf_model(bytes.substr(0, i), "a.rbf"));
  }
  CHECK(load_rbf_model(bytes + "x", "a.rbf").error().message.starts_with("a.rbf: says "));
}

TEST_CASE("Basis functions that would make f no number are refused by their number") {
  RbfFunction good, bad;
  bad.radius = 0;
  const auto model = RbfModel::of({good, bad});
  REQUIRE_FALSE(model);
  CHECK(model.error().message.starts_with("basis function 1 is beyond the limits"));
  CHECK_FALSE(RbfModel::of({}));
}
