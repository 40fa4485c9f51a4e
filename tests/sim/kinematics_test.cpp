// Machines whose motors do not move along the axes, and what corners cost them. Worked by hand.
#include "sim/kinematics.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/junction.h"
#include "sim/planner.h"
#include "sim/sim_options.h"
#include "tests/sim/dialogue.h"

using namespace slipstick;
using Catch::Contains;

namespace {

constexpr double kRoot2 = std::numbers::sqrt2;

std::vector<ExecutedMove> made_by(const Kinematics& kinematics, const MotionLimits& limits,
                                  const std::vector<Axes>& places, double speed) {
  std::vector<ExecutedMove> made;
  Planner planner([&](const ExecutedMove& move) { made.push_back(move); }, kinematics);
  for (const Axes& place : places) planner.add(place, speed, limits, Moment(0));
  planner.advance(Moment(1'000'000'000));
  return made;
}

double seconds(const ExecutedMove& move) {
  return move.end_seconds - move.start_seconds;
}

Dialogue on(const char* kinematics) {
  PrinterOptions options;
  options.machine.kinematics = *Kinematics::named(kinematics);
  options.machine.build_volume = {280, 280, 250};
  return Dialogue(options);
}

/// Cartesian: along (x, y), at 60 mm/s.
Leg leg(double x, double y) {
  const double l = std::hypot(x, y);
  const Axes along{x / l, y / l, 0, 0};
  return {along, along, l, 60, 3000};
}

constexpr Axes kJerk{10, 10, 0.3, 5};

}  // namespace

TEST_CASE("On a CoreXY both motors make a move along X, one alone a diagonal") {
  const Kinematics corexy(Kinematics::Kind::kCoreXy);
  MotionLimits limits;
  limits.speed_max.x = limits.speed_max.y = 40;

  CHECK(made_by(corexy, limits, {{30, 0, 0, 0}}, 60).at(0).speed == Approx(40));

  // Motor A makes 60 mm on a way of 42.43: √2 times as much, in speed and in acceleration.
  const auto diagonal = made_by(corexy, limits, {{30, 30, 0, 0}}, 60).at(0);
  CHECK(diagonal.speed == Approx(40 / kRoot2));
  const double v = 40 / kRoot2;
  CHECK(seconds(diagonal) == Approx(30 * kRoot2 / v + v / (3000 / kRoot2)));
  const Kinematics cartesian;
  CHECK(made_by(cartesian, limits, {{30, 30, 0, 0}}, 60).at(0).speed == Approx(40 * kRoot2));
}

TEST_CASE("A CoreXY turns from one diagonal to the other by the acceleration of one motor") {
  // v² = 3000/√2 · 0.013 · s / (1 - s), s = sin 45°; on a cartesian machine 3000 in place of
  // 3000/√2.
  const auto ramp = [](const Kinematics& kinematics) {
    const auto made = made_by(kinematics, {}, {{30, 30, 0, 0}, {60, 0, 0, 0}}, 60);
    return seconds(made.at(0));
  };
  const auto expected = [](double acceleration) {
    const double v = std::sqrt(acceleration * 0.013 * 2.41421356);
    const double length = 30 * kRoot2;
    const double flat = length - 3600 / (2 * acceleration) - (3600 - v * v) / (2 * acceleration);
    return 60 / acceleration + flat / 60 + (60 - v) / acceleration;
  };

  CHECK(ramp(Kinematics(Kinematics::Kind::kCoreXy)) == Approx(expected(3000 / kRoot2)));
  CHECK(ramp(Kinematics()) == Approx(expected(3000)));
}

TEST_CASE("M114 counts the steps of a CoreXY's motors") {
  Dialogue dialogue = on("corexy");
  dialogue.say("G28", 20 * kSecond);
  dialogue.say("G1 X30 Y10 F6000", 5 * kSecond);

  CHECK_THAT(dialogue.say("M114"),
             Contains("X:30.00 Y:10.00 Z:0.00 E:0.00 Count A:3200 B:1600 Z:0"));
}

TEST_CASE("A delta's carriages stand where rods of their length reach the nozzle") {
  const Kinematics delta(Kinematics::Kind::kDelta);

  // √(250² - 124²) above the middle.
  const Axes middle = delta.motors({0, 0, 10, 3});
  CHECK(middle.x == Approx(227.0806));
  CHECK(middle.y == Approx(227.0806));
  CHECK(middle.z == Approx(227.0806));
  CHECK(middle.e == 3);

  // Right under tower C the rod stands upright.
  CHECK(delta.motors({0, 124, 0, 0}).z == Approx(250));
  CHECK(delta.motors({-124 * std::sqrt(0.75), -62, 0, 0}).x == Approx(250));
}

TEST_CASE("A delta cuts moves across the bed into pieces of five milliseconds") {
  const Kinematics delta(Kinematics::Kind::kDelta);

  CHECK(delta.pieces({0, 0, 5, 0}, {30, 0, 5, 0}, 60) == 100);
  CHECK(delta.pieces({0, 0, 5, 0}, {0.1, 0, 5, 0}, 60) == 1);
  CHECK(delta.pieces({0, 0, 5, 0}, {0, 0, 50, 0}, 60) == 1);
  CHECK(Kinematics().pieces({0, 0, 5, 0}, {30, 0, 5, 0}, 60) == 1);
}

TEST_CASE("A delta homes to the top, knows how far it reaches, and prints straight lines") {
  std::vector<ExecutedMove> made;
  PrinterOptions options = sim_options({{"kinematics", "delta"}})->printer;
  options.machine.build_volume = {280, 280, 250};
  Dialogue dialogue(options, [&](const ExecutedMove& move) { made.push_back(move); });

  // (250 + 217.0806) · 80 steps, and X asks for no less than all.
  CHECK_THAT(dialogue.say("G28 X", 20 * kSecond),
             Contains("X:0.00 Y:0.00 Z:250.00 E:0.00 Count A:37366 B:37366 C:37366"));
  CHECK_THAT(dialogue.say("M211"),
             Contains("Min:  X-140.00 Y-140.00 Z0.00   Max:  X140.00 Y140.00 Z250.00"));
  dialogue.say("G1 Z10 F6000", 5 * kSecond);
  dialogue.say("G1 X200 F6000", 9 * kSecond);
  CHECK_THAT(dialogue.say("M114"), Contains("X:140.00 Y:0.00 Z:10.00"));
  dialogue.say("G1 X0 Y140", 9 * kSecond);

  CHECK(made.size() == 1 + 280 + 395);  // 1.4 s and 1.98 s at 100 mm/s, 200 pieces each second
  for (std::size_t i = 1; i < made.size(); ++i) CHECK(made[i].from == made[i - 1].to);
  CHECK(made.back().to == Axes{0, 140, 10, 0});
}

TEST_CASE("A cold move of a delta is refused once") {
  Dialogue dialogue = on("delta");
  dialogue.say("G28", 20 * kSecond);

  CHECK(dialogue.say("G1 X30 E5 F1200", 5 * kSecond) == "echo: cold extrusion prevented\nok\n");
}

TEST_CASE("Classic jerk: a move starts at once with what no axis minds") {
  CHECK(safe_speed(leg(1, 0), kJerk) == Approx(10));
  CHECK(safe_speed(leg(1, 1), kJerk) == Approx(10 * kRoot2));

  // Up from 10 to 60, down to 0, at 3000 mm/s².
  MotionLimits limits;
  limits.jerk = kJerk;
  const auto made = made_by({}, limits, {{60, 0, 0, 0}}, 60);
  CHECK(seconds(made.at(0)) == Approx(50.0 / 3000 + 60.0 / 3000 + (60 - 3500.0 / 6000 - 0.6) / 60));
}

TEST_CASE("Classic jerk: a corner is as fast as its axes may change") {
  CHECK(jerk_speed(leg(1, 0), leg(1, 0), kJerk) == Approx(60));
  // X from 60 to 0 and Y from 0 to 60, where 10 are allowed.
  CHECK(jerk_speed(leg(1, 0), leg(0, 1), kJerk) == Approx(10));
  // By 10°: Y changes by 60 · sin 10° = 10.42.
  const double bend = 10 * std::numbers::pi / 180;
  CHECK(jerk_speed(leg(1, 0), leg(std::cos(bend), std::sin(bend)), kJerk) ==
        Approx(10 / std::sin(bend)));
  // Right back, the axis comes to rest on the way: 60, not 120.
  CHECK(jerk_speed(leg(1, 0), leg(-1, 0), kJerk) == Approx(10));
}

TEST_CASE("Classic jerk: where both moves may stop faster than the corner is taken, they stop") {
  // By 120°: X and Y of the one change by 90 and 52 at 60 mm/s, so the corner would be taken
  // at 6.7.
  const Leg after = leg(-0.5, std::sqrt(0.75));
  const double corner = 60 * 10 / 60.0;
  CHECK(safe_speed(after, kJerk) == Approx(10 / std::sqrt(0.75)));
  CHECK(jerk_speed(leg(1, 0), after, kJerk) == Approx(std::max(corner, 10 / std::sqrt(0.75))));
}

TEST_CASE("Linear advance leaves the extruder no more than its jerk") {
  MotionLimits limits;
  CHECK(advance_limited(3000, 0.05, limits) == 3000);
  limits.advance = 1;
  // √(0.013 · 10000 · 2.41421) = 17.716 mm/s.
  CHECK(extruder_jerk(limits) == Approx(17.716).epsilon(1e-4));
  CHECK(advance_limited(3000, 0.05, limits) == Approx(17.716 / 0.05).epsilon(1e-4));
  CHECK(advance_limited(3000, -0.05, limits) == 3000);
  CHECK(advance_limited(3000, 4, limits) == 3000);
  limits.jerk = kJerk;
  CHECK(advance_limited(3000, 0.05, limits) == Approx(5 / 0.05));
}

TEST_CASE("Jerk and advance are set and told as the firmware is built") {
  Dialogue plain;
  CHECK(plain.say("M900") == "echo:Unknown command: \"M900\"\nok\n");
  CHECK(plain.say("M205") == "  M205 B20000.00 S0.00 T0.00 J0.01\nok\n");

  PrinterOptions options;
  options.machine.limits.jerk = kDefaultJerk;
  options.machine.features = {Feature::kLinearAdvance};
  Dialogue built(options);
  CHECK(built.say("M205 X8 E2.5") == "ok\n");
  CHECK(built.say("M205") == "  M205 B20000.00 S0.00 T0.00 X8.00 Y10.00 Z0.30 E2.50\nok\n");
  CHECK(built.say("M900 K0.08") == "ok\n");
  CHECK(built.say("M900") == "echo:Advance K=0.08\nok\n");
  CHECK(built.say("M900 K11") == "?K value out of range (0-10).\nok\n");
  CHECK_THAT(
      built.say("M503", kSecond),
      Contains("T<min_travel_feedrate> X<max_jerk> Y<max_jerk> Z<max_jerk> E<max_jerk>):\n") &&
          Contains("echo:; Linear Advance:\necho:  M900 K0.08\n"));
  built.say("M502");
  CHECK(built.say("M205") == "  M205 B20000.00 S0.00 T0.00 X10.00 Y10.00 Z0.30 E5.00\nok\n");
}
