#include "drivers/marlin/sender.h"

#include <catch2/catch.hpp>

namespace slipstick {
namespace {

using namespace std::chrono_literals;

/// A sender and a printer played by the test.
class Talk {
 public:
  /// Past the greeting: lines 0 to 2 are M110, M115 and M155; the job begins with 3.
  void greet() {
    expects("");
    silence(2500ms);
    expects("\nN0 M110 N0*125\n");
    says("ok");
    silence(60ms);
    expects("N1 M115*39\n");
    says("FIRMWARE_NAME:Marlin 2.1.2 SOURCE_CODE_URL:x");
    says("Cap:AUTOREPORT_TEMP:1");
    says("Cap:EMERGENCY_PARSER:1");
    says("ok");
    expects(frame(2, "M155 S2"));
    says("ok");
    expects("");
    (void)sender.take_events();
  }

  void says(std::string_view line) { sender.receive(std::string(line) + "\n", now); }

  void expects(std::string_view bytes) { REQUIRE(sender.take_output(now) == bytes); }

  void silence(Moment time) { now += time; }

  void job(std::string_view text) { sender.push(*Line::make(text)); }

  /// Sends `text` as `number` and has it accepted.
  void prints(LineNumber number, std::string_view text) {
    job(text);
    expects(frame(number, text));
    says("ok");
  }

  void refuses(LineNumber last, std::string_view why = "checksum mismatch") {
    says("Error:" + std::string(why) + ", Last Line: " + std::to_string(last));
    says("Resend: " + std::to_string(last + 1));
    says("ok");
  }

  Sender sender;
  Moment now{};
};

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
    if (!talk.sender.take_output(talk.now).empty()) ++hellos;
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

TEST_CASE("A refused line is sent again after quiet, whether or not an ok follows the request") {
  const bool with_ok = GENERATE(true, false);
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.job("G1 X2");
  talk.expects(frame(4, "G1 X2"));

  talk.says("Error:checksum mismatch, Last Line: 3");
  talk.says("Resend: 4");
  if (with_ok) talk.says("ok");
  talk.expects("");
  CHECK(talk.sender.state() == SenderState::kResending);
  talk.silence(60ms);

  talk.expects(frame(4, "G1 X2"));
  CHECK(talk.sender.counters().resends == 1);
}

TEST_CASE("An ok for garbage is no proof: the next line's refusal takes both back") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));
  talk.says("echo:Unknown command: \"L3 G1 X1\"");
  talk.says("ok");
  talk.job("G1 X2");
  talk.expects(frame(4, "G1 X2"));

  talk.refuses(2, "Line Number is not Last Line Number+1");
  talk.silence(60ms);

  talk.expects(frame(3, "G1 X1"));
  talk.says("ok");
  talk.expects(frame(4, "G1 X2"));
}

TEST_CASE("A lost ok is found out by a new number, never by the same line again") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));

  talk.silence(5999ms);
  talk.expects("");
  talk.silence(1ms);
  talk.expects(frame(4, "M105"));
  talk.says("ok T:20.00 /0.00");
  talk.silence(60ms);
  talk.job("G1 X2");

  talk.expects(frame(5, "G1 X2"));
  CHECK(talk.sender.counters().probes == 1);
  CHECK(talk.sender.counters().resends == 0);
}

TEST_CASE("A line that never arrived is found out by the probe and sent again with the probe") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));
  talk.silence(6s);
  talk.expects(frame(4, "M105"));

  talk.refuses(2, "Line Number is not Last Line Number+1");
  talk.silence(60ms);

  talk.expects(frame(3, "G1 X1"));
  talk.says("ok");
  talk.expects(frame(4, "M105"));
}

TEST_CASE("The late ok of a slow line is not taken for the probe's") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));
  talk.silence(6s);
  talk.expects(frame(4, "M105"));
  talk.job("G1 X2");

  talk.says("ok");
  talk.expects("");
  talk.says("ok T:20.00 /0.00");
  talk.silence(60ms);

  talk.expects(frame(5, "G1 X2"));
}

TEST_CASE("Reports do not hide a lost ok; busy and heating do prove that a command runs") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));
  talk.silence(5s);
  talk.says("echo:busy: processing");
  talk.silence(5s);
  talk.says(" T:20.00 /0.00 B:20.00 /0.00 @:0 B@:0 W:?");
  talk.silence(5s);
  talk.expects("");
  talk.says(" T:20.00 /0.00 B:20.00 /0.00 @:0 B@:0");
  talk.silence(1s);

  talk.expects(frame(4, "M105"));
}

TEST_CASE("Surplus oks are ignored") {
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.says("ok");
  talk.says("ok");
  talk.job("G1 X2");
  talk.expects(frame(4, "G1 X2"));
  talk.says("ok N3 P15 B3");
  talk.job("G1 X3");

  talk.expects("");
  talk.says("ok N4 P15 B3");
  talk.expects(frame(5, "G1 X3"));
  CHECK(talk.sender.counters().surplus_oks == 3);
}

TEST_CASE("A garbled request is corrected by the last line") {
  Talk talk;
  talk.greet();
  for (LineNumber line = 3; line < 14; ++line) talk.prints(line, "G1 X1");
  talk.job("G1 X2");
  talk.expects(frame(14, "G1 X2"));

  talk.says("Error:checksum mismatch, Last Line: 13");
  talk.says("Resend: 4");
  talk.silence(60ms);

  talk.expects(frame(14, "G1 X2"));
}

TEST_CASE("start in a job means that everything is lost and nothing more is sent") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));

  talk.says("start");
  talk.silence(1h);

  talk.expects("");
  CHECK(talk.sender.state() == SenderState::kLost);
  CHECK(
      talk.sender.reason() ==
      "the printer was reset during the job: its position is lost; clear the bed and start again");
}

TEST_CASE("A reset whose start was lost is known by its request for line 1") {
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");
  talk.job("G1 X2");
  talk.expects(frame(4, "G1 X2"));

  for (LineNumber probe = 5; probe < 4 + Sender::kMaxOddRequests; ++probe) {
    talk.refuses(0, "Line Number is not Last Line Number+1");
    talk.silence(60ms);
    talk.expects(frame(probe, "M105"));
  }
  talk.refuses(0, "Line Number is not Last Line Number+1");
  talk.silence(60ms);

  talk.expects("");
  CHECK(talk.sender.state() == SenderState::kLost);
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
  talk.expects(frame(4, "M105"));
  CHECK(talk.sender.state() == SenderState::kPrinting);
  talk.says("ok T:20.00 /0.00");
  talk.expects("");
  talk.silence(60ms);
  talk.expects("");

  CHECK(talk.sender.state() == SenderState::kDone);
  CHECK(talk.sender.counters().lines_acknowledged == 1);
  CHECK(talk.sender.wants_line());
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

  LineNumber line = 4;
  for (const std::string_view text : {"M104 S0", "M140 S0", "M107", "M84"}) {
    talk.expects(frame(line++, text));
    talk.says("ok");
  }
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

TEST_CASE("Refusals without end and silence without end are given up with a reason") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  const bool refuses = GENERATE(true, false);

  int turns = 0;
  while (talk.sender.state() != SenderState::kLost && turns < 1000) {
    ++turns;
    const std::string sent = talk.sender.take_output(talk.now);
    if (refuses && !sent.empty()) talk.refuses(2);
    talk.now = talk.sender.wakeup().value_or(talk.now);
  }

  REQUIRE(talk.sender.state() == SenderState::kLost);
  CHECK_THAT(talk.sender.reason(), Catch::Contains(refuses ? "refused line 3" : "not answered"));
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
