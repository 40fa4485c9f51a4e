// Boards that stop, start anew, wait for people or say what cannot be: what is made of their words.
#include <catch2/catch.hpp>
#include <cmath>

#include "drivers/marlin/objection.h"
#include "drivers/marlin/reply.h"
#include "drivers/marlin/sensor_watch.h"
#include "tests/drivers/marlin/sender_talk.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;

Temperatures report(std::string_view text) {
  const auto read = parse_temperatures(text);
  REQUIRE(read);
  return *read;
}

std::vector<std::string> messages(Sender& sender) {
  std::vector<std::string> texts;
  for (const SenderEvent& event : sender.take_events()) {
    if (const auto* message = std::get_if<MessageSeen>(&event)) texts.push_back(message->text);
  }
  return texts;
}

TEST_CASE("A reset is known by any line of the banner, NULs before it or not") {
  const std::string line =
      GENERATE(as<std::string>(), "start", std::string("\0start", 6), "PowerUp", " External Reset",
               " Brown out Reset", " Watchdog Reset", " Software Reset", "Marlin 2.1.2",
               "echo:Marlin 1.0.2");
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.says(line);

  CHECK(talk.sender.state() == SenderState::kLost);
  CHECK_THAT(talk.sender.reason(), Catch::StartsWith("the printer was reset during the job"));
}

TEST_CASE("Why a board was reset is told") {
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.says("start");
  talk.says(" Brown out Reset");

  CHECK(messages(talk.sender) ==
        std::vector<std::string>{"the board started anew: Brown out Reset"});
}

TEST_CASE("A reset while a print is being stopped ends it") {
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.sender.stop();
  talk.expects(frame(4, "M104 S0"));
  talk.says("start");

  CHECK(talk.sender.state() == SenderState::kLost);
}

TEST_CASE("Every text after which a board does nothing more halts, in one line or two") {
  const auto* text = GENERATE(
      "Error:Heating failed, system stopped! Heater_ID: 0",
      "Error:Heating failed, system stopped! Heater_ID: E0",
      "Error:Thermal Runaway, system stopped! Heater_ID: bed",
      "Error:Thermal Malfunction, system stopped! Heater_ID: chamber",
      "Error:MAXTEMP triggered, system stopped! Heater_ID: E0 (temp: 305.12)",
      "Error:MINTEMP triggered, system stopped! Heater_ID: redundant",
      "Error:Printer halted. kill() called!",
      "Error:0\n: Extruder switched off. MAXTEMP triggered !",
      "Error:Printer stopped due to errors. Fix the error and use M999 to restart.",
      "Printer stopped due to errors. Fix the error and use M999 to restart.",
      "Error:!! STOP called because of BLTouch error - restart with M999",
      "Error:!! KILL caused by KILL button/pin", "!! KILL caused by too much inactive time",
      "Error:Heater switched off. Temperature difference between temp sensors is too high !",
      "Error:Watchdog timeout. Reset required.", "fatal:heater decoupled");
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.says(text);

  CHECK(talk.sender.state() == SenderState::kHalted);
  CHECK_FALSE(talk.sender.wants_line());
  talk.expects("");
}

TEST_CASE("Error texts of which the board thinks no more do not halt") {
  const auto* text = GENERATE(
      "Error:J out of range (0.01 to 0.3)", "Error:volume.init failed", "Error:Probing Failed",
      "Error:PID Autotune failed! Bad extruder number", "echo:Marlin is nice", "Marlin",
      "Bed X: 10.0 Y: 10.0 Z: 0.1", "restart", "starting");
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.says(text);

  CHECK(talk.sender.state() == SenderState::kPrinting);
}

TEST_CASE("A printer that is paused for its user is waited for eight hours, and not talked to") {
  Talk talk;
  talk.greet();
  talk.job("M600");
  talk.expects(frame(3, "M600"));
  talk.says("//action:paused filament_runout 0");
  for (Moment time{}; time < 8h; time += 2s) {
    talk.silence(2s);
    talk.says("echo:busy: paused for user");
    talk.expects("");
  }
  talk.says("//action:resumed");
  talk.says("ok");
  talk.job("G1 X1");

  talk.expects(frame(4, "G1 X1"));
}

TEST_CASE("Ninety silent seconds of a filament change cost probes, not the print") {
  Talk talk;
  talk.greet();
  talk.job("M600");
  talk.expects(frame(3, "M600"));
  talk.silence(30s);
  talk.expects(frame(4, "M105"));
  talk.silence(60s);
  talk.expects(frame(5, "M105"));
  for (const char* line : {"echo:busy: paused for user", "ok", "ok T:20 /0", "ok T:20 /0"}) {
    talk.says(line);
  }
  talk.silence(60ms);
  talk.job("G1 X1");

  talk.expects(frame(6, "G1 X1"));
}

TEST_CASE("A heat-up that never ends is waited for until somebody stops it") {
  Talk talk;
  talk.greet();
  talk.job("M109 S200");
  talk.expects(frame(3, "M109 S200"));
  for (Moment time{}; time < 2h; time += 1s) {
    talk.silence(1s);
    talk.says(" T:190.00 /200.00 B:60.00 /60.00 @:127 B@:12 W:?");
    talk.expects("");
  }

  talk.sender.stop();

  talk.expects("M108\n");
  talk.says("ok");
  talk.expects(frame(4, "M104 S0"));
}

TEST_CASE("That a printer says nothing is told long before it is given up") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  const Moment from = talk.now;
  Moment told{};
  while (talk.now < from + 1min && told == Moment{}) {
    (void)talk.sender.take_output(talk.now);
    if (!messages(talk.sender).empty()) told = talk.now;
    talk.silence(1s);
  }

  CHECK(told == from + 42s);
  CHECK(talk.sender.state() != SenderState::kLost);
}

TEST_CASE("A sensor that says what cannot be, twice in a row, is a fault where heat is wanted") {
  const auto* bad = GENERATE("T:nan /200.00 B:60 /60", "T:inf /200.00 B:60 /60",
                             "T:-15.00 /200.00 B:60 /60", "T:999.00 /200.00 B:60 /60",
                             "T:200 /200 B:-14.90 /60.00", "T:200 /200 B:nan /60.00");
  SensorWatch watch;

  CHECK_FALSE(watch.follow(report(bad)));
  CHECK(watch.follow(report(bad)));
}

TEST_CASE("One wild reading, or any where no heat is wanted, is no fault") {
  SensorWatch watch;
  for (int time = 0; time < 5; ++time) {
    CHECK_FALSE(watch.follow(report("T:800.00 /200.00 B:nan /60.00")));
    CHECK_FALSE(watch.follow(report("T:201.00 /200.00 B:60.00 /60.00")));
    CHECK_FALSE(watch.follow(report("T:-15.00 /0.00 B:nan /0.00")));
  }
}

TEST_CASE("Temperatures of every firmware are read, negative ones and those of several tools too") {
  CHECK(report("T0:-55.7 /0.0 B:-3.2 /0.0").hotend->celsius == -55.7);
  CHECK(report("T0:-55.7 /0.0 B:-3.2 /0.0").bed->celsius == -3.2);
  CHECK(report("B:22.4 /0.0 T0:21.9 /205.0").hotend == HeaterReading{21.9, 205.0});
  CHECK(report("T:21.87/0.00 B:22.10/60.00 @:0 B@:0").bed == HeaterReading{22.1, 60.0});
  CHECK(report("T:23.3 /0.0 @0 T1:24.0 /0.0 @0 B:20.0 /0.0 @0").tools.size() == 1);
  const auto mk3 = report("T:26.9 /0.0 B:25.9 /0.0 T0:26.9 /0.0 @:0 B@:0 P:19.8 A:26.4");
  CHECK(mk3.hotend == HeaterReading{26.9, 0.0});
  const auto two = report("T:20.00 /0.00 B:21.00 /0.00 T0:20.00 /0.00 T1:22.50 /180.00 @:0 B@:0");
  CHECK(two.tools == std::vector<HeaterReading>{{20.0, 0.0}, {22.5, 180.0}});
  CHECK(report("T0:20 /0 T1:22 /0").hotend == std::nullopt);
}

TEST_CASE("B of a position is no bed, with axes or with towers") {
  for (const std::string_view text :
       {"X:0.00 Y:0.00 Z:0.00 E:0.00 Count A:12 B:13 C:14", "Count A:12 B:13 C:14", "X:1 B:2"}) {
    CHECK_FALSE(std::holds_alternative<Temperatures>(parse_reply(text)));
  }
}

TEST_CASE("What was acknowledged but not done is told from what is merely said") {
  for (const std::string_view text :
       {"cold extrusion prevented", "too long extrusion prevented", "T3 Invalid extruder",
        "Home XYZ First", "Home Z First", "G2/G3 bad parameters",
        "Printer locked! (Unlock with M511 or LCD)"}) {
    INFO(text);
    CHECK(objection_in(text) == Objection::kNotDone);
  }
  for (const std::string_view text : {"M105 Invalid extruder 9", "Home", "Settings Stored", ""}) {
    INFO(text);
    CHECK(objection_in(text) == Objection::kNone);
  }
  CHECK(objection_in("Unknown command: \"G2 X1\"") == Objection::kUnknown);
}

}  // namespace
}  // namespace slipstick
