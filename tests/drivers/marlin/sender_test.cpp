#include "drivers/marlin/sender.h"

#include <catch2/catch.hpp>

#include "tests/drivers/marlin/sender_talk.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;

TEST_CASE("The greeting numbers the lines, asks for the name and arms the reports") {
  Talk talk;

  talk.greet();

  CHECK(talk.sender.state() == SenderState::kReady);
  CHECK(talk.sender.wakeup() == std::nullopt);
}

TEST_CASE("The greeting waits for a booting board to finish its banner") {
  Talk talk;

  talk.expects("");
  talk.silence(1s);
  talk.says("start");
  talk.silence(500ms);
  talk.says("echo:SD card ok");
  talk.silence(600ms);
  talk.expects("");
  talk.silence(100ms);

  talk.expects("\nN0 M110 N0*125\n");
}

TEST_CASE("A silent printer is greeted again, then given up") {
  Talk talk;
  talk.expects("");

  int hellos = 0;
  for (int turn = 0; turn < 1000 && talk.sender.state() == SenderState::kGreeting; ++turn) {
    talk.now = talk.sender.wakeup().value_or(talk.now);
    if (talk.sender.take_output(talk.now) == "\nN0 M110 N0*125\n") ++hellos;
  }

  CHECK(hellos == Sender::kGreetingAttempts);
  CHECK(talk.sender.state() == SenderState::kLost);
  CHECK(talk.sender.reason() ==
        "no Marlin answers; check the port, the baud rate and that the printer is on");
}

TEST_CASE("A printer without reports is asked, with a number, between lines") {
  Talk talk;
  talk.expects("");
  talk.silence(2500ms);
  talk.expects("\nN0 M110 N0*125\n");
  talk.says("ok");
  talk.silence(60ms);
  talk.expects("N1 M115*39\n");
  talk.says("FIRMWARE_NAME:Marlin 1.1.9");
  talk.says("ok");
  talk.expects(frame(2, "M105"));
  talk.says("ok T:20.00 /0.00");

  talk.expects(frame(3, "M105"));
  talk.says("ok T:20.00 /0.00");
  talk.expects("");
  talk.silence(9s);
  talk.expects("");
  talk.silence(1s);

  talk.expects(frame(4, "M105"));
}

TEST_CASE("One line is in flight at a time, and each ok lets the next go") {
  Talk talk;
  talk.greet();

  talk.job("G28");
  talk.expects("N3 G28*16\n");
  CHECK(talk.sender.state() == SenderState::kWaiting);
  talk.job("G1 X1");
  talk.expects("");
  talk.says("echo:busy: processing");
  talk.expects("");
  talk.says("ok");
  talk.expects(frame(4, "G1 X1"));

  CHECK(talk.sender.state() == SenderState::kPrinting);
}

TEST_CASE("A fatal text halts, a harmless error does not") {
  Talk talk;
  talk.greet();
  talk.job("G2 X1");
  talk.expects(frame(3, "G2 X1"));
  talk.says("Error:G2/G3 bad parameters");
  talk.says("ok");
  CHECK(talk.sender.state() == SenderState::kPrinting);

  talk.says("Error:MAXTEMP triggered, system stopped! Heater_ID: E0");
  talk.says("Error:Printer halted. kill() called!");

  CHECK(talk.sender.state() == SenderState::kHalted);
  CHECK(talk.sender.reason() ==
        "the printer stopped itself: MAXTEMP triggered, system stopped! Heater_ID: E0");
  CHECK_FALSE(talk.sender.wants_line());
}

TEST_CASE("Done is said only after the printer proved that it took the last line") {
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.sender.end_of_job();
  talk.falls_silent(4);
  talk.expects(frame(5, "M105"));
  CHECK(talk.sender.state() == SenderState::kPrinting);
  talk.says("ok T:20.00 /0.00");
  talk.expects("");
  talk.silence(60ms);
  talk.expects("");

  CHECK(talk.sender.state() == SenderState::kDone);
  CHECK(talk.sender.counters().lines_acknowledged == 1);
  CHECK(talk.sender.wants_line());
}

// A firmware may stand still when nobody reads what it says (mpmd_marlin_1.1.x issue 48).
TEST_CASE("Reports end with the print, also those that the sender before has asked for") {
  Talk talk;
  talk.greet();
  talk.sender.end_of_job();
  talk.falls_silent(3);
  talk.expects(frame(4, "M105"));

  const bool reports = GENERATE(true, false);
  Sender second({.first_number = 0, .kept = KeptSession{4, {}}});
  second.push(*Line::make("G1 X1"));
  REQUIRE(second.take_output(0s) == frame(5, "M105"));
  second.receive("ok T:20.00 /0.00\n", 0s);
  REQUIRE(second.take_output(0s) == frame(6, "G1 X1"));
  if (reports) second.receive(" T:20.00 /0.00 B:20.00 /0.00 @:0 B@:0\n", 1s);
  second.receive("ok\n", 1s);
  second.end_of_job();

  CHECK(second.take_output(1s) == frame(7, reports ? "M155 S0" : "M105"));
}

TEST_CASE("A bare ok does not prove that the last line was taken") {
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.sender.end_of_job();
  talk.falls_silent(4);
  talk.expects(frame(5, "M105"));

  talk.says("ok");
  talk.silence(60ms);
  talk.expects("");
  CHECK(talk.sender.state() == SenderState::kPrinting);
  talk.silence(1s);

  talk.expects(frame(6, "M105"));
}

TEST_CASE("Stopping drops the job's next line and switches everything off, numbered") {
  Talk talk;
  talk.greet();
  talk.job("M109 S200");
  talk.expects(frame(3, "M109 S200"));
  talk.job("G1 X1");

  talk.sender.stop();
  talk.expects("M108\n");
  talk.says("ok");
  const bool both_oks_come_at_once = GENERATE(false, true);
  if (both_oks_come_at_once) talk.says("ok");

  LineNumber line = 4;
  for (const std::string_view text : {"M104 S0", "M140 S0", "M107", "M84"}) {
    talk.expects(frame(line++, text));
    talk.says("ok");
  }
  talk.falls_silent(line++);
  talk.expects(frame(line, "M105"));
  talk.says("ok T:20.00 /0.00");
  talk.silence(60ms);
  talk.expects("");
  CHECK(talk.sender.state() == SenderState::kDone);
}

TEST_CASE("An emergency stop goes out at once and again until the printer has died") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.sender.emergency_stop();

  talk.expects("\nM112\n");
  talk.expects("");
  talk.silence(250ms);
  talk.expects("\nM112\n");
  talk.says("Error:Printer halted. kill() called!");
  talk.silence(250ms);

  talk.expects("");
  CHECK(talk.sender.state() == SenderState::kHalted);
  CHECK(talk.sender.wakeup() == std::nullopt);
}

TEST_CASE("From every state the first bytes after an emergency stop are the raw M112") {
  const auto bring_to = GENERATE(
      as<void (*)(Talk&)>(), [](Talk&) {},   // closed
      [](Talk& talk) { talk.expects(""); },  // greeting
      [](Talk& talk) { talk.greet(); },      // ready
      [](Talk& talk) {
        talk.greet();
        talk.job("G1 X1");
      },
      [](Talk& talk) {
        talk.greet();
        talk.job("M109 S200");
        talk.expects(frame(3, "M109 S200"));
      },
      [](Talk& talk) {
        talk.greet();
        talk.job("G1 X1");
        talk.expects(frame(3, "G1 X1"));
        talk.refuses(2);
      },
      [](Talk& talk) {
        talk.greet();
        talk.job("G1 X1");
        talk.expects(frame(3, "G1 X1"));
        talk.silence(6s);
        talk.expects(frame(4, "M105"));
      },
      [](Talk& talk) {
        talk.greet();
        talk.sender.stop();
      },
      [](Talk& talk) {
        talk.greet();
        talk.sender.abandon("test");
      },
      [](Talk& talk) {
        talk.greet();
        talk.says("Error:Printer halted. kill() called!");
      });
  Talk talk;
  bring_to(talk);

  talk.sender.emergency_stop();

  talk.expects("\nM112\n");
  CHECK((talk.sender.state() == SenderState::kHalted || talk.sender.state() == SenderState::kLost));
}

TEST_CASE("Events nobody takes are bounded") {
  Talk talk;
  talk.greet();

  for (int i = 0; i < 1000; ++i) talk.says("echo:hello");

  CHECK(talk.sender.take_events().size() == Sender::kMaxEvents);
  CHECK(talk.sender.counters().events_dropped == 1000 - Sender::kMaxEvents);
}

}  // namespace
}  // namespace slipstick
