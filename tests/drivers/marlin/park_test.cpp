#include "drivers/marlin/park.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

namespace slipstick {
namespace {

constexpr ParkingPlace kPlace{.x = 5,
                              .y = 215,
                              .height_max = 250,
                              .retraction = 1.5,
                              .retraction_speed = 30,
                              .travel_speed = 100,
                              .lift_speed = 10};

PrintStateTracker job(const std::vector<std::string>& lines) {
  PrintStateTracker tracker;
  for (const std::string& line : lines) tracker.follow(line);
  return tracker;
}

std::vector<std::string> texts(const std::vector<Line>& lines) {
  std::vector<std::string> texts;
  for (const Line& line : lines) texts.push_back(line.text());
  return texts;
}

std::vector<std::string> parking(const std::vector<std::string>& lines) {
  return texts(parking_lines(job(lines).state(), kPlace));
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
  return std::ranges::count(lines, line) == 1;
}

TEST_CASE("A print that was parked and came back is in the state it was left in") {
  const std::string moves = GENERATE("G90", "G91");
  const std::string extrusion = GENERATE("M82", "M83");
  PrintStateTracker tracker =
      job({"G92 E0", "M104 S210", "M140 S60", "M106 S128", "G1 X10.125 Y20.0005 Z0.3 F1234 E7",
           moves, extrusion, "G1 X1.001 Y3 E0.12345"});
  const PrintState left = tracker.state();

  for (const Line& line : parking_lines(left, kPlace)) tracker.follow(line.text());
  const PrintState parked = tracker.state();
  for (const Line& line : returning_lines(left, kPlace)) tracker.follow(line.text());
  PrintState back = tracker.state();

  CHECK(parked.position[0] == 5.0);
  CHECK(parked.position[1] == 215.0);
  CHECK(parked.position[2] == *left.position[2] + ParkingPlace::kLift);
  CHECK(parked.nozzle == left.nozzle);
  for (std::size_t axis = 0; axis < back.position.size(); ++axis) {
    CHECK(*back.position[axis] == Approx(*left.position[axis]).margin(1e-9));
  }
  back.position = left.position;
  CHECK(back == left);
}

TEST_CASE("The nozzle is lifted over all that was laid, and no higher than the machine goes") {
  CHECK(has(parking({"G1 X1 Y1 Z40", "G1 X2 E1", "G0 Z3"}), "G0 Z50 F600"));
  CHECK(has(parking({"G1 X1 Y1 Z40", "G0 Z3"}), "G0 Z13 F600"));
  CHECK(has(parking({"G1 X1 Y1 Z246"}), "G0 Z250 F600"));
  CHECK(has(parking({"G1 X1 Y1 Z260"}), "G0 Z260 F600"));
}

TEST_CASE(
    "A nozzle whose place is not known stays, and one in renamed coordinates is lifted only") {
  CHECK(parking({"G28"}).empty());
  CHECK(parking({"G28", "G1 X1 Y1"}).empty());
  CHECK(parking({"G20", "G1 X1 Y1 Z1"}).empty());

  const auto lifted = parking({"G1 X1 Y1 Z1", "G92 X100"});

  CHECK(has(lifted, "G0 Z11 F600"));
  CHECK_FALSE(has(lifted, "G0 X5 Y215 F6000"));
}

TEST_CASE("Filament moves only in a nozzle that was heated") {
  CHECK(has(parking({"M104 S200", "G1 X1 Y1 Z1"}), "G1 E-1.5 F1800"));
  for (const auto& cold : {parking({"G1 X1 Y1 Z1"}), parking({"M104 S150", "G1 X1 Y1 Z1"})}) {
    CHECK(std::ranges::none_of(cold, [](auto& line) { return line.starts_with("G1 E"); }));
  }
}

TEST_CASE("The motors keep their power, and the nozzle waits for its heat before it comes back") {
  const PrintStateTracker tracker = job({"M104 S200", "M140 S60", "G1 X1 Y1 Z1"});

  CHECK(texts(parking_lines(tracker.state(), kPlace)).front() == "M84 S0");
  const auto back = texts(returning_lines(tracker.state(), kPlace));
  CHECK(std::vector(back.begin(), back.begin() + 3) ==
        std::vector<std::string>{"M104 S200", "M190 S60", "M109 S200"});
  CHECK(texts(returning_lines(job({"M104 S200"}).state(), kPlace)) ==
        std::vector<std::string>{"M104 S200", "M109 S200"});
}

}  // namespace
}  // namespace slipstick
