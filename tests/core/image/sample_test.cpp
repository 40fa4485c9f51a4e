#include "core/image/sample.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/solids.h"

using namespace slipstick;

namespace {

// Inside where `rule` says, known as a whole over boxes the rule decides alone.
class HalfPlane final : public Section {
 public:
  explicit HalfPlane(double edge) : edge_(edge) {}
  void classify(std::span<const double> xs, std::span<const double>,
                std::span<std::uint8_t> inside) override {
    asked_ += xs.size();
    for (std::size_t i = 0; i < xs.size(); ++i) inside[i] = xs[i] <= edge_ ? 1 : 0;
  }
  Narrowed narrowed(const Box2& box) override {
    if (box.high.x <= edge_) return {Cover::kInside, nullptr};
    if (box.low.x > edge_) return {Cover::kOutside, nullptr};
    return {};
  }
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  double edge_;
  std::size_t asked_ = 0;
};

class Undefined final : public Section {
 public:
  void classify(std::span<const double>, std::span<const double>,
                std::span<std::uint8_t> inside) override {
    std::fill(inside.begin(), inside.end(), std::uint8_t{0});
  }
  Narrowed narrowed(const Box2&) override { return {}; }
  [[nodiscard]] std::optional<Vec2> undefined_at() const override { return Vec2{1, 2}; }
};

}  // namespace

TEST_CASE("Tiles known as a whole are filled and give the same image as every node asked") {
  const auto grid = SliceGrid::over({{0, 0}, {40, 30}}, 0.125);
  for (const double edge : {-1.0, 0.0, 7.3, 20.0, 39.99, 100.0}) {
    HalfPlane plane(edge);

    const auto image = sample(plane, *grid);

    REQUIRE(image);
    for (int row = 0; row < grid->rows(); ++row) {
      for (int column = 0; column < grid->columns(); ++column) {
        const bool ring =
            row == 0 || column == 0 || row == grid->rows() - 1 || column == grid->columns() - 1;
        REQUIRE(image->at(column, row) == (!ring && grid->node_x(column) <= edge));
      }
    }
    CHECK(plane.asked() < static_cast<std::size_t>(grid->rows()) * 40);
  }
}

TEST_CASE("NaN in a plane is an error that says where") {
  Undefined section;

  const auto image = sample(section, *SliceGrid::over({{0, 0}, {4, 4}}, 0.1));

  REQUIRE_FALSE(image);
  CHECK_THAT(image.error().message, Catch::Contains("x=1 y=2"));
}

TEST_CASE("Grid coordinates are exact and the lattice does not depend on the window") {
  const auto a = SliceGrid::over({{0, 0}, {4, 4}}, 0.1),
             b = SliceGrid::over({{-3, 1}, {9, 5}}, 0.1);

  const auto shift = static_cast<int>(a->first_column() - b->first_column());

  CHECK(a->node_x(5) == b->node_x(5 + shift));
  CHECK(a->width() <= 0.1);
  CHECK(a->width() > 0.1 - 1e-6);
  CHECK(a->node_x(1) - a->node_x(0) == a->width());
}

TEST_CASE("A lattice too fine for the window is refused with the sampling that would do") {
  const auto grid = SliceGrid::over({{0, 0}, {200, 200}}, 0.01);

  REQUIRE_FALSE(grid);
  CHECK_THAT(grid.error().message, Catch::Contains("--sampling 0.0122"));
  CHECK(SliceGrid::over({{0, 0}, {200, 200}}, 0.0123));
  CHECK_FALSE(SliceGrid::over({{0, 0}, {4, 4}}, 0));
  CHECK_FALSE(SliceGrid::over({{0, 0}, {4, 4}}, std::nan("")));
  CHECK_FALSE(SliceGrid::over(Box2{}, 0.1));
}
