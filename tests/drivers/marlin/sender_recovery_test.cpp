#include <catch2/catch.hpp>

#include "drivers/marlin/safe_stop.h"
#include "tests/drivers/marlin/sender_talk.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;

// Says `line` every two seconds and nothing else, until it is given up or for `most`. \return how
// long.
Moment keeps_saying(Talk& talk, std::string_view line, Moment most) {
  const Moment from = talk.now;
  while (talk.sender.state() != SenderState::kLost && talk.now - from < most) {
    talk.silence(2s);
    talk.says(line);
    static_cast<void>(talk.sender.take_output(talk.now));
  }
  return talk.now - from;
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

TEST_CASE("An ok for garbage is no proof: a probe's refusal takes it back") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));
  talk.says("echo:Unknown command: \"L3 G1 X1\"");
  talk.says("ok");
  talk.job("G1 X2");
  talk.expects(frame(4, "M105"));

  talk.refuses(2, "Line Number is not Last Line Number+1");
  talk.is_asked_and_stands_at(3, "X:0.00 Y:0.00 Z:0.00 E:0.00");

  talk.expects(frame(5, "G1 X1"));
  talk.says("ok");
  talk.expects(frame(6, "M105"));
  talk.says("ok T:20.00 /0.00");
  talk.expects(frame(7, "G1 X2"));
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
  talk.is_asked_and_stands_at(3, "X:0.00 Y:0.00 Z:0.00 E:0.00");

  talk.expects(frame(5, "G1 X1"));
  talk.says("ok");
  talk.expects(frame(6, "M105"));
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

TEST_CASE("start in a job means that everything is lost: heaters off, nothing more of the job") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));

  talk.says("start");

  for (int time = 0; time < Sender::kSafeStops; ++time) {
    talk.expects(numbered_safe_stop());
    talk.silence(1h);
  }
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

  talk.expects(numbered_safe_stop());
  CHECK(talk.sender.state() == SenderState::kLost);
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

// Its serial line is dead one way, or its firmware hangs in a loop that still reports.
TEST_CASE("A printer that reports for ever but obeys nothing is given up") {
  Talk talk;
  talk.greet();
  talk.job("G1 X1");
  talk.expects(frame(3, "G1 X1"));

  const Moment took = keeps_saying(talk, " T:205.00 /205.00 B:60.00 /60.00 @:0 B@:0", 2h);

  CHECK(talk.sender.state() == SenderState::kLost);
  CHECK_THAT(talk.sender.reason(), Catch::Contains("obeyed nothing since line 2"));
  CHECK(took >= Sender::kDeafMax);
  CHECK(took <= Sender::kDeafMax + Sender::kAliveWindow + 5s);
}

TEST_CASE("A printer that says that it is busy is waited for however long it takes") {
  Talk talk;
  talk.greet();
  talk.job("M600");
  talk.expects(frame(3, "M600"));

  CHECK(keeps_saying(talk, "echo:busy: paused for user", 2h) >= 2h);

  CHECK(talk.sender.state() != SenderState::kLost);
}

}  // namespace
}  // namespace slipstick
