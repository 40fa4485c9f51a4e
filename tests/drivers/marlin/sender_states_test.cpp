// The table of states in drivers/README.md, transition by transition.
#include <catch2/catch.hpp>

#include "tests/drivers/marlin/sender_talk.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;
using enum SenderState;

struct Journey : Talk {
  void is(SenderState state) const { REQUIRE(sender.state() == state); }

  void print_one() {
    greet();
    prints(3, "G1 X1");
    is(kPrinting);
  }

  void finish(LineNumber number) {
    sender.end_of_job();
    falls_silent(number++);
    expects(frame(number, "M105"));
    says("ok T:20.00 /0.00");
    silence(60ms);
    expects("");
  }
};

TEST_CASE("States follow one another from greeting to done and to the next job") {
  Journey journey;
  journey.is(kGreeting);
  journey.greet();
  journey.is(kReady);
  journey.job("G1 X1");
  journey.is(kPrinting);
  journey.expects(frame(3, "G1 X1"));
  journey.says("ok");
  journey.is(kPrinting);
  journey.finish(4);
  journey.is(kDone);
  journey.job("G1 X2");
  journey.is(kPrinting);
  journey.expects(frame(6, "M155 S2"));
  journey.says("ok");
  journey.expects(frame(7, "G1 X2"));
}

TEST_CASE("A blocking command is waited for, and then lines flow again") {
  Journey journey;
  journey.print_one();
  journey.job("M190 S60");
  journey.expects(frame(4, "M190 S60"));
  journey.is(kWaiting);
  journey.says("ok");
  journey.is(kPrinting);
}

TEST_CASE("A refusal or a silence is found out about, and then lines flow again") {
  const bool refused = GENERATE(true, false);
  Journey journey;
  journey.print_one();
  journey.job("G1 X2");
  journey.expects(frame(4, "G1 X2"));
  if (refused) {
    journey.refuses(3);
    journey.is(kResending);
    journey.silence(60ms);
    journey.expects(frame(4, "G1 X2"));
    journey.says("ok");
  } else {
    journey.silence(6s);
    journey.expects(frame(5, "M105"));
    journey.is(kResending);
    journey.says("ok T:20.00 /0.00");
    journey.silence(60ms);
    journey.expects("");
  }
  journey.is(kPrinting);
}

TEST_CASE("Stopping leads to done, from ready and from the middle of a print") {
  const bool printing = GENERATE(true, false);
  Journey journey;
  journey.greet();
  LineNumber number = 3;
  if (printing) journey.prints(number++, "G1 X1");
  journey.sender.stop();
  journey.is(kPrinting);
  for (const char* text : {"M104 S0", "M140 S0", "M107", "M84"}) {
    journey.expects(frame(number++, text));
    journey.says("ok");
  }
  journey.falls_silent(number++);
  journey.expects(frame(number, "M105"));
  journey.says("ok T:20.00 /0.00");
  journey.silence(60ms);
  journey.expects("");
  journey.is(kDone);
}

TEST_CASE("Halted and lost are reached from every other state and never left") {
  const auto bring_to = GENERATE(
      as<void (*)(Journey&)>(), [](Journey& j) { j.expects(""); }, [](Journey& j) { j.greet(); },
      [](Journey& j) { j.print_one(); },
      [](Journey& j) {
        j.print_one();
        j.finish(4);
      });
  const SenderState end = GENERATE(kHalted, kLost);
  Journey journey;
  bring_to(journey);

  if (end == kHalted) journey.says("Error:Printer halted. kill() called!");
  if (end == kLost) journey.sender.abandon("test");
  journey.is(end);

  CHECK_FALSE(journey.sender.wants_line());
  for (const char* line : {"ok", "start", "Resend: 1", "Error:Printer halted. kill() called!"}) {
    journey.says(line);
    journey.is(end);
  }
  journey.sender.stop();
  journey.sender.end_of_job();
  journey.sender.emergency_stop();
  journey.is(end);
}

TEST_CASE("A reset is lost in a job, and greeted again before one") {
  Journey before;
  before.expects("");
  before.says("start");
  before.is(kGreeting);

  Journey within;
  within.print_one();
  within.says("start");
  within.is(kLost);
}

}  // namespace
}  // namespace slipstick
