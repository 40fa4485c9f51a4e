#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/contour/audit.h"
#include "core/contour/place_laplacian.h"
#include "core/contour/place_roots.h"
#include "core/contour/place_smooth.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/image/sample.h"
#include "core/solid/bsp_build.h"
#include "core/solid/bsp_model.h"
#include "core/solid/mesh_model.h"
#include "tests/support/outlines.h"
#include "tests/support/shapes.h"

using namespace slipstick;

namespace {

// A disc of radius `radius` about the origin.
class Disc final : public Section {
 public:
  explicit Disc(double radius) : radius_(radius) {}
  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override {
    for (std::size_t i = 0; i < xs.size(); ++i) {
      inside[i] = std::hypot(xs[i], ys[i]) <= radius_ ? 1 : 0;
    }
  }
  Narrowed narrowed(const Box2&) override { return {}; }

 private:
  double radius_;
};

constexpr double kRadius = 3;
constexpr double kWidth = 0.125;

ContourSet disc_contours() {
  Disc disc(kRadius);
  const auto grid = SliceGrid::over({{-kRadius, -kRadius}, {kRadius, kRadius}}, kWidth);
  return trace(*sample(disc, *grid), Ambiguity::kSolid);
}

double worst_error(const Outline& outline) {
  double worst = 0;
  for (const GridPoint p : outline.loops()[0].points) {
    worst = std::max(worst, std::abs(length(outline.mm(p)) - kRadius));
  }
  return worst;
}

bool contains(Section& section, const SliceGrid& grid, GridPoint p) {
  const double x = grid.x_of(p.x), y = grid.y_of(p.y);
  std::uint8_t inside = 0;
  section.classify({&x, 1}, {&y, 1}, {&inside, 1});
  return inside != 0;
}

// Planes through vertices of the mesh, in between, and near its end.
void check_parted(const Solid& solid, const test::Shape& shape) {
  const Box3 box = solid.bounds();
  const auto grid = SliceGrid::over({{box.low.x, box.low.y}, {box.high.x, box.high.y}}, kWidth);
  for (const double share : {0.01, 0.5, 0.77}) {
    INFO(shape.name << " at " << share);
    const auto section = solid.section(box.low.z + share * box.size().z);
    ContourSet contours = trace(*sample(*section, *grid), Ambiguity::kSolid);
    place_roots(contours, *section);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < contours.sticks().size(); ++i) {
      const Stick stick = contours.sticks()[i];
      const std::int32_t k = contours.places()[i].value();
      // Places stop short of the nodes.
      const bool inside = k == Place::kLowest || contains(*section, *grid, along(stick, k));
      const bool outside = k == Place::kHighest || !contains(*section, *grid, along(stick, k + 1));
      if (!inside || !outside) ++wrong;
    }
    CHECK(wrong == 0);
  }
}

}  // namespace

TEST_CASE("Roots of a mesh and of its tree part inside from outside, between neighbouring places") {
  for (const test::Shape& shape : test::shapes()) {
    const TriangleMesh mesh = test::mesh_of(shape, 12);
    const auto tree = bsp_of(mesh);
    REQUIRE(tree);
    check_parted(*MeshModel(mesh).placed({}), shape);
    check_parted(*(*BspModel::of(*tree))->placed({}), shape);
  }
}

TEST_CASE("Ordinary Laplacian smoothing shrinks a disc; brought back, it still parts the samples") {
  ContourSet contours = disc_contours();
  const std::vector<Vec2> smoothed = free_laplacian(contours, contours.loops()[0]);

  double area = 0;
  for (std::size_t i = 0; i < smoothed.size(); ++i) {
    area += 0.5 * cross(smoothed[i], smoothed[(i + 1) % smoothed.size()]) * kWidth * kWidth;
  }
  CHECK(area < 0.99 * std::numbers::pi * kRadius * kRadius);

  place_laplacian(contours);
  Disc disc(kRadius);
  CHECK(audit_samples(test::audit_loops_of(keep_all(contours).outline),
                      *sample(disc, contours.grid()))
            .empty());
}

TEST_CASE("Roots lie on the boundary to a part in 65536 of a cell") {
  Disc disc(kRadius);
  ContourSet contours = disc_contours();

  place_roots(contours, disc);

  // One unit along the stick moves a vertex by no more than one unit towards the boundary.
  CHECK(worst_error(keep_all(contours).outline) <= 2 * kWidth / 65536);
}

TEST_CASE("The boundary lies within one unit of a root on either side") {
  Disc disc(kRadius);
  ContourSet contours = disc_contours();

  place_roots(contours, disc);

  const SliceGrid& grid = contours.grid();
  for (std::size_t i = 0; i < contours.sticks().size(); ++i) {
    const auto far = [&](int k) {
      const GridPoint p = along(contours.sticks()[i], contours.places()[i].value() + k);
      return std::hypot(grid.x_of(p.x), grid.y_of(p.y));
    };
    CHECK(far(-1) <= kRadius);
    CHECK(far(1) > kRadius);
  }
}

TEST_CASE("Sliding brings vertices nearer to a circle than midpoints are") {
  ContourSet contours = disc_contours();
  const double before = worst_error(keep_all(contours).outline);

  place_sliding(contours);

  CHECK(worst_error(keep_all(contours).outline) < before);
}

TEST_CASE("Sliding depends on the sticks alone, not on where vertices were") {
  ContourSet contours = disc_contours();
  place_sliding(contours);
  const std::vector<Place> first(contours.places().begin(), contours.places().end());

  place_sliding(contours);

  CHECK(std::equal(first.begin(), first.end(), contours.places().begin()));
}

TEST_CASE("Simplification stays within its tolerance and needs far fewer edges") {
  Disc disc(kRadius);
  ContourSet contours = disc_contours();
  place_roots(contours, disc);

  for (const auto simplify : {simplify_vsa, simplify_greedy}) {
    const Simplified result = simplify(contours, {0.0125, 10});

    CHECK(result.max_deviation <= 0.0125);
    CHECK(result.max_deviation > 0);
    CHECK(result.edges_before == contours.sticks().size());
    CHECK(result.outline.edges() * 3 < result.edges_before);
    CHECK(worst_error(result.outline) < 1e-4);
  }
}

TEST_CASE("A larger tolerance never gives more edges on a circle") {
  Disc disc(kRadius);
  ContourSet contours = disc_contours();
  place_roots(contours, disc);
  std::size_t before = contours.sticks().size();
  for (const double tolerance : {0.002, 0.01, 0.05}) {
    const std::size_t edges = simplify_greedy(contours, {tolerance, 10}).outline.edges();

    CHECK(edges <= before);
    before = edges;
  }
}
