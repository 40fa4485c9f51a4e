#include "drivers/marlin/position.h"

#include <catch2/catch.hpp>
#include <initializer_list>

namespace slipstick {
namespace {

Position after(std::initializer_list<const char*> lines) {
  PositionTracker tracker;
  for (const char* line : lines) tracker.follow(line);
  return tracker.position();
}

TEST_CASE("Moves are followed in absolute and relative coordinates, extrusion for itself") {
  CHECK(after({"G1 X1 Y2 Z.3", "G0 X4"}) == Position{4.0, 2.0, 0.3, {}});
  CHECK(after({"G92 E0", "M83", "G1 E1", "G1 X2 E1.5"}) == Position{2.0, {}, {}, 2.5});
  CHECK(after({"G1 X1 E1", "G91", "G1 X1 E1"}) == Position{2.0, {}, {}, 2.0});
  CHECK(after({"G1 X1 E1", "G91", "M82", "G1 X1 E5", "G90", "G1 X7"}) ==
        Position{7.0, {}, {}, 5.0});
}

TEST_CASE("What moves the nozzle elsewhere makes its place unknown, until the next move") {
  for (const char* elsewhere : {"G29", "M600", "G92", "M501", "G27 P2", "G20"}) {
    INFO(elsewhere);
    CHECK(after({"G1 X1 Y2 Z3 E4", elsewhere}) == Position());
  }
  CHECK(after({"G1 X1 E4", "G28", "G1 Y2"}) == Position{std::nullopt, 2.0, std::nullopt, 4.0});
  CHECK(after({"G20", "G1 X1"}) == Position());
  CHECK(after({"G1 X1", "M104 S200", "G4 P1", "M117 G1 X9"}) == Position{1.0, {}, {}, {}});
}

TEST_CASE("A relative move from an unknown place leads to an unknown place") {
  CHECK(after({"G91", "G1 X1"}) == Position());
  CHECK(after({"M83", "G1 E1"}) == Position());
}

TEST_CASE("A report finds a lost place again, and tools keep the extruder's") {
  PositionTracker tracker;
  tracker.follow("G28");
  CHECK_FALSE(tracker.lost());
  tracker.follow("M83");
  CHECK(tracker.lost());
  tracker.learn({1.0, 2.0, 3.0, 4.0});
  CHECK_FALSE(tracker.lost());
  CHECK(tracker.follow("T0") == Position{std::nullopt, std::nullopt, std::nullopt, 4.0});
  CHECK(tracker.follow("G1 X5 E-1") == Position{5.0, std::nullopt, std::nullopt, 3.0});
  tracker.follow("G91");
  CHECK(tracker.lost());
}

TEST_CASE("A report is read whole or not at all") {
  const Position place{10.0, -2.5, 0.2, 1234.5};
  CHECK(parse_position("X:10.00 Y:-2.50 Z:0.20 E:1234.50 Count X:800 Y:0 Z:80") == place);
  CHECK(parse_position("X: 10.00 Y: -2.50 Z: 0.20 E: 1234.50 Count X: 800") == place);
  for (const char* bad : {"X:10.00 Y:-2.50 Z:0.20 E:1234.50", "X:10.00 Y:-2.50 Z:0.20 Count X:8",
                          "X:10.00 Y-2.50 Z:0.20 E:1234.50 Count ", "X:nan Y:0 Z:0 E:0 Count X:0",
                          "X:1x.0 Y:0 Z:0 E:0 Count X:0", ""}) {
    INFO(bad);
    CHECK(parse_position(bad) == std::nullopt);
  }
}

TEST_CASE("A report tells what was executed when the line went somewhere") {
  const Position here{1.0, 1.0, {}, {}};
  const Position there{2.0, 1.0, {}, {}};
  const Position near{1.02, 1.0, {}, {}};

  REQUIRE(tells_apart(here, there));
  CHECK(executed({2.0, 1.0, 0.0, 0.0}, here, there) == Executed::kYes);
  CHECK(executed({1.0, 1.0, 0.0, 0.0}, here, there) == Executed::kNo);
  CHECK(executed({1.5, 1.0, 0.0, 0.0}, here, there) == Executed::kUnclear);
  CHECK(executed({2.0, 7.0, 0.0, 0.0}, here, there) == Executed::kUnclear);
  CHECK_FALSE(tells_apart(here, near));
  CHECK_FALSE(tells_apart({}, {}));
  CHECK(tells_apart({}, there));
}

}  // namespace
}  // namespace slipstick
