#include "drivers/marlin/print_state.h"

#include <catch2/catch.hpp>
#include <initializer_list>

namespace slipstick {
namespace {

PrintState after(std::initializer_list<const char*> lines) {
  PrintStateTracker tracker;
  for (const char* line : lines) tracker.follow(line);
  return tracker.state();
}

TEST_CASE("Place, modes and feed rate are those of the last line that says them") {
  const PrintState state =
      after({"G1 X1 Y2 Z3 F1800", "M83", "G0 X4", "G91", "G1 Y1 F0", "M82", "M117 G1 F9"});

  CHECK(state.position == Position{4.0, 3.0, 3.0, {}});
  CHECK(state.relative);
  CHECK_FALSE(state.relative_extrusion);
  CHECK(state.feed == 1800.0);
  CHECK(knows_place(state));
  CHECK_FALSE(knows_place(after({"G28", "G1 X1 Y1"})));
}

TEST_CASE("Temperatures are those asked for, of the tool in use, however they are asked for") {
  CHECK(after({"M104 S200", "M140 S60"}).nozzle == 200.0);
  CHECK(after({"M109 R190", "M190 S60", "M104"}).nozzle == 190.0);
  CHECK(after({"M104 S200", "M190 R60", "M140 S0"}).bed == 0.0);
  CHECK(after({"M104 S200", "M104 T1 S150", "M104 T0 S210"}).nozzle == 210.0);
  CHECK_FALSE(after({"M104 S200", "T1"}).nozzle);
  CHECK(after({"T1", "M104 S170", "T1"}).nozzle == 170.0);
}

TEST_CASE("The fan is the one that blows at the part") {
  CHECK_FALSE(after({"M106 P1 S9"}).fan);
  CHECK(after({"M106"}).fan == 255.0);
  CHECK(after({"M106 S100", "M107 P1"}).fan == 100.0);
  CHECK(after({"M106 S100", "M107"}).fan == 0.0);
}

TEST_CASE("The top is the height at which plastic was laid, not that of a travel") {
  CHECK_FALSE(after({"G1 Z50", "G1 X1 Y1", "M83", "G1 E5", "G1 X2 E-1"}).top);
  CHECK(after({"G1 Z0.4", "G1 X1 Y1 E1", "G0 Z20"}).top == 0.4);
  CHECK_FALSE(after({"G92 E5", "G1 Z1", "G1 X1 E4"}).top);
  CHECK(after({"M83", "G1 Z2", "G1 X1 E.1", "G1 Z1", "G1 X2 E.1"}).top == 2.0);
}

TEST_CASE("Coordinates are known to be the machine's until something renames them") {
  CHECK_FALSE(after({"G28", "G92 E0", "G1 X1 Y1 Z1"}).renamed);
  for (const char* line : {"G92 X0", "G92", "G92 Z1 E0", "M206 X1", "G54", "G52 X1"}) {
    INFO(line);
    CHECK(after({line, "G1 X1 Y1 Z1"}).renamed);
  }
}

}  // namespace
}  // namespace slipstick
