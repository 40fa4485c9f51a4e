#include "core/contour/certify.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/formats/lua_script.h"
#include "core/image/sample.h"
#include "tests/support/flood.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

class Subject {
 public:
  explicit Subject(const std::string& script) {
    const auto model = load_lua_model(script, "test.lua");
    REQUIRE(model.has_value());
    solid_ = (*model)->placed({});
  }

  [[nodiscard]] SliceGrid grid(double h) const {
    const Box3 b = solid_->bounds();
    return SliceGrid::over({{b.low.x, b.low.y}, {b.high.x, b.high.y}}, h).value();
  }
  [[nodiscard]] BitImage image(double z, double h) const { return image(z, grid(h)); }
  [[nodiscard]] BitImage image(double z, const SliceGrid& grid) const {
    return sample(*solid_->section(z), grid).value();
  }
  [[nodiscard]] LayerCertificate certificate(double z, double above, double h) const {
    return certify_layer(*field(), image(z, h), z, above);
  }
  [[nodiscard]] std::unique_ptr<Field> field() const { return solid_->field(); }

 private:
  std::shared_ptr<const Solid> solid_;
};

std::int64_t squares_passed_slowly(const BitImage& image) {
  std::int64_t sum = 0;
  for (int row = 0; row + 1 < image.rows(); ++row) {
    for (int column = 0; column + 1 < image.columns(); ++column) {
      const int inside = image.at(column, row) + image.at(column + 1, row) +
                         image.at(column, row + 1) + image.at(column + 1, row + 1);
      sum += inside > 0 && inside < 4 ? 1 : 0;
    }
  }
  return sum;
}

bool holds(const Box3& box, Vec3 p) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y &&
         box.low.z <= p.z && p.z <= box.high.z;
}

bool hidden_at(const LayerCertificate& certificate, Vec3 p) {
  return std::any_of(certificate.events.begin(), certificate.events.end(), [p](const auto& e) {
    return e.kind == SlabEvent::Kind::kHidden && holds(e.box, p);
  });
}

std::string wave(Rng& rng) {
  const auto number = [&rng](double most) { return (rng.unit() * 2 - 1) * most; };
  return fmt::format("{} * sin({}*x + {}*y + {}*z + {})", 0.3 + rng.unit(), number(2), number(2),
                     number(2), number(3));
}

// A smooth solid of waves within a ball.
Subject random_blobs(Rng& rng) {
  return Subject(
      fmt::format("return ({} + {} + {} + 0.3*(x^2 + y^2 + z^2) - 1)"
                  ":bounds(-5,-5,-5,5,5,5)",
                  wave(rng), wave(rng), wave(rng)));
}

struct Planar {
  int components, holes;
  friend bool operator==(const Planar&, const Planar&) = default;
};

Planar planar(const BitImage& image) {
  return {components(image, 8), holes(image, 4)};
}

constexpr double kH = 0.1;
constexpr double kLayer = 0.2;

}  // namespace

TEST_CASE("Every square of a gyroid's slice is certified", "[certify]") {
  // Looked at within, away from the edges of the box that it is cut off by.
  const Subject gyroid("return gyroid(10, 1.2):bounds(-12, -12, -12, 12, 12, 12)");
  const SliceGrid window = SliceGrid::over({{-10, -10}, {10, 10}}, kH).value();
  for (const double z : {-3.13, 0.1, 2.5}) {
    const BitImage image = gyroid.image(z, window);
    const LayerCertificate c = certify_layer(*gyroid.field(), image, z, z + kLayer);

    CHECK(c.uncertified == 0);
    CHECK(c.hidden() == 0);
    CHECK(c.complete);
    CHECK(c.cells > 1000);
    CHECK(c.cells == squares_passed_slowly(image));
  }
}

TEST_CASE("A certified slice has the topology of one four times as fine", "[certify]") {
  Rng rng(7);
  int certified = 0;
  for (int round = 0; round < 12; ++round) {
    const Subject blobs = random_blobs(rng);
    const double z = rng.unit() * 4 - 2;
    if (blobs.certificate(z, z, 0.2).uncertified != 0) continue;
    ++certified;
    CAPTURE(round, z);
    CHECK(planar(blobs.image(z, 0.2)) == planar(blobs.image(z, 0.05)));
  }
  CHECK(certified >= 8);
}

TEST_CASE("A saddle beside the curve leaves no square open", "[certify]") {
  // Its middle is that of a square, which the curve goes around.
  const Subject saddle(
      "local u, v = x - 0.05, y - 0.05\nreturn (u * (u + v) - v * (u + v) + 0.003):bounds(-2, -2, "
      "-2, 2, 2, 2)");
  const SliceGrid window = SliceGrid::over({{-1, -1}, {1, 1}}, kH).value();
  const BitImage image = saddle.image(0, window);

  const LayerCertificate c = certify_layer(*saddle.field(), image, 0, 0);

  CHECK(c.cells > 20);
  CHECK(c.uncertified == 0);
}

TEST_CASE("A corner of the curve within a square is certified", "[certify]") {
  // On a diagonal: there f goes up and down along x, and along y.
  const Subject wedge("return (0.8 * (x + y) + abs(x - y) - 0.1):bounds(-4, -4, -4, 4, 4, 4)");
  const SliceGrid window = SliceGrid::over({{-1, -1}, {1, 1}}, kH).value();
  const BitImage image = wedge.image(0, window);

  const LayerCertificate c = certify_layer(*wedge.field(), image, 0, 0);

  CHECK(c.cells > 10);
  CHECK(c.uncertified == 0);
}

TEST_CASE("Certified conics have the topology of a slice eight times as fine", "[certify]") {
  Rng rng(21);
  int certified = 0, open = 0;
  for (int round = 0; round < 300; ++round) {
    // About as thin as a square, or much thinner, or with such a gap; cut off by a disc.
    const double a = std::pow(10.0, 4 * rng.unit()), turn = 3.15 * rng.unit();
    const double c = std::cos(turn), s = std::sin(turn), sign = rng.below(2) == 0 ? 1 : -1;
    const std::string u = fmt::format("({}*x + {}*y - {})", c, s, 0.1 * rng.unit());
    const std::string v = fmt::format("({}*x - {}*y - {})", s, c, 0.1 * rng.unit());
    const Subject conic(
        fmt::format("return max({}*({}^2 - {}*{}^2 - {}), x^2 + y^2 - 1.43)"
                    ":bounds(-2, -2, -2, 2, 2, 2)",
                    sign, u, sign * a, v, 0.1 + 0.3 * rng.unit()));
    if (conic.certificate(0, 0, kH).uncertified != 0) {
      ++open;
      continue;
    }
    ++certified;
    CAPTURE(round, a, turn, sign);
    CHECK(planar(conic.image(0, kH)) == planar(conic.image(0, kH / 8)));
  }
  CHECK(certified > 100);
  CHECK(open > 20);
}

TEST_CASE("Certified squares do not depend on where the window begins", "[certify]") {
  Rng rng(10);
  for (int round = 0; round < 6; ++round) {
    const Subject blobs = random_blobs(rng);
    const double z = rng.unit() * 4 - 2;
    const SliceGrid grid = blobs.grid(kH);
    const double shift = kH * static_cast<double>(1 + rng.below(70));
    const Box2 wider{{grid.node_x(0) - shift, grid.node_y(0) - 2 * shift},
                     {grid.node_x(grid.columns() - 1), grid.node_y(grid.rows() - 1)}};
    const BitImage here = blobs.image(z, grid);
    const BitImage there = blobs.image(z, SliceGrid::over(wider, kH).value());
    REQUIRE(there.grid().columns() > here.grid().columns());

    const LayerCertificate a = certify_layer(*blobs.field(), here, z, z + kLayer);
    const LayerCertificate b = certify_layer(*blobs.field(), there, z, z + kLayer);

    CHECK(a.cells == b.cells);
    CHECK(a.uncertified == b.uncertified);
    CHECK(a.hidden() == b.hidden());
  }
}

TEST_CASE("What a slice cannot show is not certified", "[certify]") {
  // A rod between the samples, a hundredth of a millimetre thick.
  const Subject rod("return union(box(4, 4, 1), cylinder(0.01, 3):move(0.05, 0.05, 0))");

  const LayerCertificate c = rod.certificate(1, 1.1, kH);

  REQUIRE(c.uncertified > 0);
  CHECK(length(c.uncertified_at[0] - Vec2{0.05, 0.05}) < kH);
  CHECK_FALSE(c.proved());
}

TEST_CASE("Islands, gaps, membranes and necks between two planes are found", "[certify]") {
  Rng rng(8);
  for (const double share : {0.1, 0.5, 0.9}) {
    const double thick = share * kLayer;
    // Somewhere within the slab from 0.05 to 0.25, not touching its planes.
    const double z = 0.05 + thick / 2 + rng.unit() * (kLayer - thick);
    const double x = 0.6 * rng.unit() - 0.3;
    const auto find = [&](const std::string& script, Vec3 at) {
      CAPTURE(script);
      const LayerCertificate c = Subject(script).certificate(0.05, 0.25, kH);
      CHECK(hidden_at(c, at));
    };
    const std::string rods = "cylinder(0.5, 3):move(-1, 0, 0), cylinder(0.5, 3):move(1, 0, 0), ";
    find(fmt::format("return union({}sphere({}):move({}, 0, {}))", rods, thick / 2, x, z),
         {x, 0, z});
    find(fmt::format("return union({}box(1, 1, {}):move(0, 0, {}))", rods, thick, z), {0, 0, z});
    find(fmt::format("return difference(box(3, 3, 3), box(1, 1, {}):move(0, 0, {}))", thick, z),
         {0, 0, z});
    find(
        fmt::format("return difference(box(3, 3, 3), sphere({}):move({}, 0, {}))", thick / 2, x, z),
        {x, 0, z});
    find(fmt::format("return union({}cylinder({}, 2):rotate(0, 90, 0):move(0, 0, {}))", rods,
                     thick / 2, z),
         {0, 0, z});
  }
}

TEST_CASE("A leaning island is found too", "[certify]") {
  const Subject s(
      "return union(box(4, 4, 1):move(5,0,0),"
      "sphere(1):scale(0.3, 0.3, 0.05):rotate(0, 12, 0):move(0, 0, 0.15))");

  // Its top and its bottom are at two places; both are on it.
  const LayerCertificate c = s.certificate(0.05, 0.25, kH);
  CHECK(c.hidden() >= 1);
  for (const SlabEvent& e : c.events) {
    if (e.kind == SlabEvent::Kind::kHidden) CHECK(std::abs(e.box.centre().x) < 0.4);
  }
}

TEST_CASE("Tops, bottoms and terraces are steps, not hidden", "[certify]") {
  const auto steps_only = [](const std::string& script, double z) {
    const LayerCertificate c = Subject(script).certificate(z, z + kLayer, kH);
    CAPTURE(script, z, c.events.size());
    CHECK(c.complete);
    CHECK(c.hidden() == 0);
    CHECK_FALSE(c.events.empty());
  };
  steps_only("return sphere(5)", 4.9);
  steps_only("return sphere(5)", -5.1);
  steps_only("return torus(4, 1)", 0.9);
  steps_only("return torus(4, 1):rotate(90, 0, 0)", 2.95);  // a saddle
  steps_only("return union(box(6, 6, 2), box(3, 3, 4))", 0.9);
  steps_only("return box(4, 4, 4):rotate(45, 35, 0)", 3.3);
  steps_only("return difference(box(4, 4, 4), sphere(1))", -1.1);
}

TEST_CASE("Nothing hides within upright walls", "[certify]") {
  const Subject s("return difference(box(6, 6, 6), cylinder(2, 8))");

  const LayerCertificate c = s.certificate(0.1, 0.3, kH);

  CHECK(c.hidden() == 0);
  // What is left open is the four edges of the box: there the gradient turns by a right angle.
  CHECK(c.uncertified == 4 * 3);
  for (const Vec2 p : c.uncertified_at) CHECK(std::min(std::abs(p.x), std::abs(p.y)) > 2.8);
}

TEST_CASE("Where planes in between have another topology there is an event", "[certify]") {
  Rng rng(12);
  constexpr double kThick = 0.6;
  constexpr int kPlanes = 6;
  int changes = 0;
  for (int round = 0; round < 8; ++round) {
    const Subject blobs = random_blobs(rng);
    const double z = rng.unit() * 4 - 2;
    const std::size_t events = blobs.certificate(z, z + kThick, 0.2).events.size();
    std::size_t found = 0;
    std::optional<Planar> before;
    for (int i = 0; i <= kPlanes; ++i) {
      const double at = z + kThick * i / kPlanes;
      if (blobs.certificate(at, at, 0.1).uncertified != 0) continue;
      const Planar now = planar(blobs.image(at, 0.1));
      found += before && !(*before == now) ? 1U : 0U;
      before = now;
    }
    CAPTURE(round, z);
    CHECK(events >= found);
    changes += static_cast<int>(found);
  }
  CHECK(changes >= 4);
}

TEST_CASE("A slab below the first slice shows what stands below it", "[certify]") {
  const Subject s("return union(box(4, 4, 4):move(0, 0, 2), box(2, 2, 0.1):move(4, 0, 0.05))");

  const LayerCertificate c = certify_slab(*s.field(), s.grid(kH), -0.1, 0.15);

  CHECK(hidden_at(c, {4, 0, 0.05}));
  CHECK_FALSE(hidden_at(c, {0, 0, 0}));
  CHECK(c.cells == 0);
}

TEST_CASE("A field of which nothing is known is given up in time", "[certify]") {
  class Unknown final : public Field {
   public:
    GradientRange over(const Box3&) override {
      ++asked;
      return {};
    }
    std::unique_ptr<Field> narrowed(const Box3&) override { return nullptr; }
    std::int64_t asked = 0;
  };
  Unknown field;

  const LayerCertificate c = certify_slab(field, Subject("return sphere(50)").grid(0.1), 0, 1);

  CHECK_FALSE(c.complete);
  CHECK_FALSE(c.proved());
  CHECK(field.asked < kCertifyBoxesMax + 1000);
}
