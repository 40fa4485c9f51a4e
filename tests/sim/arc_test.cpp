#include "sim/arc.h"

#include <catch2/catch.hpp>
#include <string>

#include "sim/gcode_player.h"

using namespace slipstick;

namespace {

Arc arc(const std::string& line, const Axes& from, const Axes& to) {
  return Arc::of(parse_gcode(line).value(), from, to).value();
}

double distance(const Axes& a, const Vec2& centre) {
  return length(Vec2{a.x, a.y} - centre);
}

}  // namespace

TEST_CASE("Every piece of an arc ends on it, the last where it was sent to") {
  const Arc half = arc("G2 I5 J0", {0, 0, 1, 0}, {10, 0, 2, 4});

  for (int i = 1; i < half.pieces(); ++i) CHECK(distance(half.end_of(i), {5, 0}) == Approx(5));
  CHECK(half.end_of(half.pieces()) == Axes{10, 0, 2, 4});
}

TEST_CASE("Clockwise from the left goes over the top, counter-clockwise below; Z and E keep step") {
  const Axes from{0, 0, 1, 0}, to{10, 0, 2, 4};
  const Arc over = arc("G2 I5 J0", from, to);
  const Arc below = arc("G3 I5 J0", from, to);
  const Axes top = over.end_of(over.pieces() / 2);
  const Axes bottom = below.end_of(below.pieces() / 2);

  CHECK(top.x == Approx(5));
  CHECK(top.y == Approx(5));
  CHECK(top.z == Approx(1.5));
  CHECK(top.e == Approx(2));
  CHECK(bottom.y == Approx(-5));
}

TEST_CASE("A radius goes the short way, a negative one the long way, a short one half round") {
  const Axes from{0, 0, 0, 0}, to{10, 0, 0, 0};
  const auto highest = [&](const std::string& line) {
    const Arc a = arc(line, from, to);
    double y = 0;
    for (int i = 1; i <= a.pieces(); ++i) y = std::max(y, a.end_of(i).y);
    return y;
  };

  // The sagitta of a chord of 10 in a circle of radius r: r - sqrt(r² - 25), and the rest of it.
  CHECK(highest("G2 R13") == Approx(1).margin(0.01));
  CHECK(highest("G2 R-13") == Approx(25).margin(0.01));
  CHECK(highest("G2 R1") == Approx(5).margin(0.01));
}

TEST_CASE("Pieces are a millimetre where that is fine enough, a 72nd of the circle where not") {
  const Axes at{0, 0, 0, 0};
  CHECK(arc("G2 I100", at, at).pieces() == 628);
  CHECK(arc("G2 I5", at, at).pieces() == 72);
  CHECK(arc("G2 I0.5", at, at).pieces() == 31);
  CHECK(arc("G2 I0.01", at, at).pieces() == 1);
  CHECK(arc("G2 I1000000", at, at).pieces() == Arc::kPiecesMax);
}

TEST_CASE("No centre, no arc") {
  const auto none = [](const char* line, const Axes& to) {
    return !Arc::of(parse_gcode(line).value(), {}, to);
  };
  CHECK(none("G2 X5", {5, 0, 0, 0}));
  CHECK(none("G2 R5", {}));
  CHECK(none("G2 R0 X5", {5, 0, 0, 0}));
  CHECK(none("G3 I0 J0", {}));
}

TEST_CASE("A program with arcs is played, its bad ones are refused") {
  double way = 0;
  GcodePlayer player({220, 220, 250},
                     [&](const ExecutedMove& move) { way += length((move.to - move.from).xyz()); });
  player.play("G1 X60 Y50 F6000");
  player.play("G2 I5 J0 F3000");
  player.play("G2 X1 Y1");
  player.finish();

  // A polygon of 72 corners is 0.03 % shorter than its circle.
  CHECK(way == Approx(std::sqrt(60 * 60 + 50 * 50) + 2 * 5 * 3.14159265).epsilon(0.0005));
  REQUIRE(player.refused() == 1);
  CHECK(player.refusals().front().line == 3);
}
