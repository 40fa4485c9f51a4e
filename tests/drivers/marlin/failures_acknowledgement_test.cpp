// Acknowledgements that are lost, late, doubled, damaged or nobody's: what other hosts hang on.
#include <catch2/catch.hpp>

#include "tests/drivers/marlin/sender_talk.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;

struct Silence : Talk {
  /// Time passes in which the printer says nothing. \return what it is sent meanwhile.
  std::string is_silent_for(Moment time) {
    const Moment until = now + time;
    std::string sent;
    while (now < until) {
      now = std::min(until, std::max(now + 1ms, sender.wakeup().value_or(until)));
      sent += sender.take_output(now);
    }
    return sent;
  }

  /// Line 3 is sent and not answered.
  void sends(std::string_view text) {
    greet();
    job(text);
    expects(frame(3, text));
  }

  /// All probes are answered; then the job goes on with `number`.
  void answers_probes_and_goes_on(int probes, LineNumber number) {
    for (int probe = 0; probe < probes; ++probe) says("ok T:20.00 /0.00");
    silence(60ms);
    job("G1 X99");
    expects(frame(number, "G1 X99"));
    CHECK(sender.counters().resends == 0);
  }
};

TEST_CASE("An ok that noise has changed costs one probe, whatever it was changed to") {
  const auto* changed = GENERATE("o3", "7k", "okk", "k", "\x8fk", "1k N23153 P63 B7");
  Silence talk;
  talk.sends("G1 X1");
  talk.says(changed);

  CHECK(talk.is_silent_for(6s) == frame(4, "M105"));
  talk.answers_probes_and_goes_on(1, 5);
}

TEST_CASE("An ok glued to the next reply costs one probe") {
  const auto* glued = GENERATE("okecho:busy: processing", "okok", "ok T:20.00 /0.00ok", "waitok",
                               "okstart of something");
  Silence talk;
  talk.sends("G1 X1");
  talk.says(glued);

  CHECK(talk.is_silent_for(6s) == frame(4, "M105"));
  talk.answers_probes_and_goes_on(1, 5);
}

TEST_CASE("An ok that is a minute late is waited for while reports come") {
  Silence talk;
  talk.sends("G1 X1");
  std::string sent;
  for (int time = 0; time < 30; ++time) {
    sent += talk.is_silent_for(2s);
    talk.says(" T:205.00 /205.00 B:60.00 /60.00 @:0 B@:0");
  }
  REQUIRE(sent == frame(4, "M105") + frame(5, "M105") + frame(6, "M105"));

  talk.says("ok");
  talk.answers_probes_and_goes_on(3, 7);
}

// Heating down with neither busy nor temperatures, as boards of some makers do it.
TEST_CASE("A wait that is silent for ten minutes is not given up") {
  Silence talk;
  talk.sends("M190 R30");

  const std::string sent = talk.is_silent_for(10min);

  CHECK(talk.sender.state() != SenderState::kLost);
  talk.says("ok");
  talk.answers_probes_and_goes_on(static_cast<int>(std::ranges::count(sent, '\n')), 8);
}

TEST_CASE("A wait whose ok seemed to come early is not given up either") {
  const auto* command = GENERATE("M190 R30", "G4 S600");
  Silence talk;
  talk.greet();
  talk.prints(3, command);
  talk.job("G1 X1");
  talk.expects(frame(4, "G1 X1"));

  const std::string sent = talk.is_silent_for(20min);

  CHECK(talk.sender.state() != SenderState::kLost);
  if (command[0] == 'M') talk.says("ok");  // its own; a dwell was acknowledged for good
  talk.says("ok");
  talk.answers_probes_and_goes_on(static_cast<int>(std::ranges::count(sent, '\n')), 10);
}

TEST_CASE("Behind a wait that is over silence is given up as elsewhere") {
  Silence talk;
  talk.greet();
  talk.prints(3, "M190 R30");
  talk.prints(4, "G1 X1");
  talk.prints(5, "G1 X2");
  talk.job("G1 X3");
  talk.expects(frame(6, "G1 X3"));

  (void)talk.is_silent_for(10min);

  CHECK(talk.sender.state() == SenderState::kLost);
}

TEST_CASE("Free words instead of busy keep a blocking command alive") {
  Silence talk;
  talk.sends("G29");
  std::string sent;
  for (int time = 0; time < 60; ++time) {
    talk.says("Wait for bed heating...");
    sent += talk.is_silent_for(10s);
  }

  CHECK(talk.sender.state() != SenderState::kLost);
  talk.says("ok");
  talk.answers_probes_and_goes_on(static_cast<int>(std::ranges::count(sent, '\n')), 8);
}

TEST_CASE("The lost ok of a heat-up is found out by a probe") {
  Silence talk;
  talk.sends("M190 S60");
  for (int second = 0; second < 40; ++second) {
    talk.says(" T:20.00 /0.00 B:50.00 /60.00 @:0 B@:127 W:?");
    CHECK(talk.is_silent_for(1s).empty());
  }

  CHECK(talk.is_silent_for(30s) == frame(4, "M105"));
  talk.answers_probes_and_goes_on(1, 5);
}

TEST_CASE("That the printer waits for somebody is told, once") {
  Silence talk;
  talk.sends("M190 S60");

  for (int time = 0; time < 100; ++time) {
    talk.says("echo:busy: processing");
    CHECK(talk.is_silent_for(2s).empty());
  }
  CHECK(talk.sender.take_events().empty());
  for (int time = 0; time < 100; ++time) {
    talk.says("echo:busy: paused for user");
    CHECK(talk.is_silent_for(2s).empty());
  }

  CHECK(talk.sender.take_events() ==
        std::vector<SenderEvent>{MessageSeen{"busy: paused for user"}});
}

TEST_CASE("Wait instead of the ok of the greeting: it is begun again") {
  Talk talk;
  talk.expects("");
  talk.silence(2500ms);
  talk.expects("\nN0 M110 N0*125\n");
  talk.says("\x8fk");
  talk.silence(1s);
  talk.says("wait");
  talk.expects("");
  talk.silence(200ms);

  talk.expects("\nN0 M110 N0*125\n");
}

TEST_CASE("Wait sends nothing that nobody asked for") {
  Talk talk;
  talk.greet();
  talk.prints(3, "G1 X1");

  for (int time = 0; time < 10; ++time) {
    talk.silence(1s);
    talk.says("wait");
    talk.expects("");
  }
}

TEST_CASE("Wait just behind the ok of a long dwell does not mean that the next line was lost") {
  Talk talk;
  talk.greet();
  talk.job("G4 S54");
  talk.expects(frame(3, "G4 S54"));
  talk.silence(54s);
  talk.says("ok");
  talk.job("G1 X1");
  talk.expects(frame(4, "G1 X1"));
  talk.silence(1ms);
  talk.says("wait");

  talk.expects("");
  talk.says("ok");
  talk.job("G1 X2");
  talk.expects(frame(5, "G1 X2"));
}

TEST_CASE("An ok that is there the moment the line is written is that line's") {
  Talk talk;
  talk.expects("");
  talk.silence(2500ms);
  REQUIRE(talk.sender.take_output(talk.now) == "\nN0 M110 N0*125\n");
  talk.says("ok");
  talk.silence(60ms);
  talk.expects("N1 M115*39\n");
  talk.says("ok");
  talk.expects(frame(2, "M115"));  // without its name it is asked again
}

// M303 of old firmware: an ok at once, a minute of silence, another ok.
TEST_CASE(
    "A command that is acknowledged twice, silent in between, neither loses nor skips lines") {
  Silence talk;
  talk.greet();
  talk.prints(3, "M303 E0 S200 C8");
  talk.job("M104 S1");
  talk.expects(frame(4, "M104 S1"));
  REQUIRE(talk.is_silent_for(66s) == frame(5, "M105") + frame(6, "M105") + frame(7, "M105"));
  talk.says("ok");
  talk.silence(100ms);
  const bool flushed = GENERATE(false, true);  // what was sent meanwhile

  if (!flushed) {
    talk.says("ok");
    talk.answers_probes_and_goes_on(3, 8);
    return;
  }
  talk.says("wait");
  talk.expects(frame(8, "M105"));
  talk.refuses(3, "Line Number is not Last Line Number+1");
  talk.silence(60ms);
  talk.expects(frame(4, "M104 S1"));
  talk.says("ok");
  talk.expects(frame(5, "M105"));
}

TEST_CASE("A query that is not acknowledged costs one probe") {
  Silence talk;
  talk.sends("M105 T9");
  talk.says("echo:M105 Invalid extruder 9");

  CHECK(talk.is_silent_for(6s) == frame(4, "M105"));
  talk.answers_probes_and_goes_on(1, 5);
}

// As boards say it that have two copies of their output: byte by byte.
TEST_CASE("Temperatures that come doubled are no readings and hold nothing up") {
  Silence talk;
  talk.sends("G1 X1");
  talk.says("TT::-15.00-15.00  //0.000.00  BB::24.26");
  talk.says("ok");
  talk.expects(frame(4, "M105"));
  talk.says("ok TT::-15.00-15.00  //0.000.00  BB::24.26");
  talk.silence(60ms);
  talk.job("G1 X2");

  talk.expects(frame(5, "G1 X2"));
  for (const SenderEvent& event : talk.sender.take_events()) {
    CHECK_FALSE(std::holds_alternative<TemperaturesSeen>(event));
  }
}

}  // namespace
}  // namespace slipstick
