// Requests for lines: doubled, without an ok, in other words, out of another session, or missing.
#include <catch2/catch.hpp>

#include "tests/drivers/marlin/sender_talk.h"
#include "tests/support/marlin_model_voyage.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;

/// A line that may be given twice, so that nobody need ask whether it was obeyed.
constexpr std::string_view kText = "M104 S1";

struct Refusal : Talk {
  void sends() {
    greet();
    job(kText);
    expects(frame(3, kText));
  }
};

TEST_CASE("Two refusals of one line send it again once") {
  const bool apart = GENERATE(false, true);
  Refusal talk;
  talk.sends();
  talk.refuses(2);
  if (apart) talk.silence(50ms);
  talk.refuses(2);
  talk.expects("");
  talk.silence(60ms);

  talk.expects(frame(3, kText));
  talk.says("ok");
  talk.job("G1 X1");
  talk.expects(frame(4, "G1 X1"));
  CHECK(talk.sender.counters().resends == 1);
}

TEST_CASE("Each line that is sent again waits for its own ok, however often it is refused") {
  Refusal talk;
  talk.sends();
  for (int time = 0; time < 5; ++time) {
    talk.refuses(2);
    talk.expects("");
    talk.silence(60ms);
    talk.expects(frame(3, kText));
  }
  talk.job("G1 X1");
  talk.expects("");
  talk.says("ok");

  talk.expects(frame(4, "G1 X1"));
}

TEST_CASE("Requests left over from another session are not obeyed") {
  Talk talk;
  talk.expects("");
  for (int time = 0; time < 20; ++time) talk.says("Resend: 634");
  talk.silence(2500ms);
  talk.expects("\nN0 M110 N0*125\n");
  for (int time = 0; time < 20; ++time) talk.says("Resend: 634");
  talk.says("ok");
  talk.silence(60ms);
  talk.expects("");
  talk.silence(200ms);

  talk.expects("\nN0 M110 N0*125\n");
  talk.says("ok");
  talk.silence(60ms);
  talk.expects("N1 M115*39\n");
}

TEST_CASE("A board that holds the M110 against its own count is given up before anything moves") {
  Talk talk;
  talk.expects("");
  std::string sent;
  for (int turn = 0; turn < 1000 && talk.sender.state() == SenderState::kGreeting; ++turn) {
    talk.now = talk.sender.wakeup().value_or(talk.now);
    const std::string hello = talk.sender.take_output(talk.now);
    if (hello.empty() || talk.sender.state() != SenderState::kGreeting) continue;
    sent += hello;
    talk.says("Error:Wrong checksum");
    talk.says("Resend: 11");
    talk.says("ok");
  }

  CHECK(talk.sender.state() == SenderState::kLost);
  CHECK_THAT(talk.sender.reason(), Catch::Contains("no Marlin answers"));
  std::string hellos;
  for (int time = 0; time < Sender::kGreetingAttempts; ++time) hellos += "\nN0 M110 N0*125\n";
  CHECK(sent == hellos);
}

TEST_CASE("An error without a request and without an ok is a refusal all the same") {
  Refusal talk;
  talk.sends();
  talk.says("Error:No Line Number with checksum, Last Line: 2");
  talk.silence(60ms);

  talk.expects(frame(3, kText));
}

TEST_CASE("In whatever words a line is refused, the number of the request counts") {
  const auto* words =
      GENERATE("Error:checksum mismatch", "Error:Wrong checksum", "Error:Checksum error",
               "Error:Missing checksum", "Error:Format error", "Error:expected line 3 got 5",
               "Error:Line Number out of sequence. Expected: 3 Got: 239", "something else");
  const auto* request = GENERATE("Resend: 3", "Resend:3", "rs 3", "rs N3 Expected checksum 109");
  Refusal talk;
  talk.sends();
  talk.says(words);
  talk.expects("");
  talk.says(request);
  talk.silence(60ms);

  talk.expects(frame(3, kText));
}

TEST_CASE("A line that the board says it could not hold is asked about and sent again") {
  const auto* words = GENERATE("Full RX Buffer", "RX timeout", "echo:RX timeout", "");
  Refusal talk;
  talk.sends();
  talk.says(words);
  talk.silence(6s);
  talk.expects(frame(4, "M105"));
  talk.refuses(2, "Line Number is not Last Line Number+1");
  talk.silence(60ms);

  talk.expects(frame(3, kText));
}

TEST_CASE("On a slow link damage is made good without a storm of requests") {
  const auto job = std::vector<std::string>{"G28",       "M83",          "G1 X1 E.1", "G1 X2 E.2",
                                            "G1 X3 E.3", "M106 S255",    "G1 X4 E.4", "G1 X5 E.5",
                                            "G4 P100",   "G1 X6 Y1 E.6", "G1 X7 E.7"};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    INFO("seed " << seed);
    const WireFaults slow{.damage = 5e-3, .latency = 300ms};
    Voyage voyage({.down = slow, .up = slow}, seed);

    REQUIRE(voyage.print(job) == SenderState::kDone);
    REQUIRE(job_lines(voyage.printer().executed()) == job);
    REQUIRE(voyage.sender().counters().resends <= 3 * voyage.faults());
  }
}

TEST_CASE("A line that is refused for ever ends the print with its number, at once and cold") {
  Refusal talk;
  talk.sends();
  int refusals = 0;
  while (talk.sender.state() != SenderState::kLost && refusals < 1000) {
    ++refusals;
    talk.refuses(2);
    talk.silence(60ms);
    (void)talk.sender.take_output(talk.now);
  }

  CHECK(refusals == Sender::kMaxRewinds + 1);
  CHECK_THAT(talk.sender.reason(), Catch::Contains("refused line 3"));
}

}  // namespace
}  // namespace slipstick
