// The first seconds: garbage, bootloaders, boards that are late or reset after they were greeted.
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "tests/drivers/marlin/sender_talk.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;
using namespace std::string_literals;

constexpr std::string_view kHello = "\nN0 M110 N0*125\n";

struct Meeting : Talk {
  void is_greeted() {
    expects("");
    silence(2500ms);
    expects(kHello);
  }

  void goes_on() {
    says("ok");
    silence(60ms);
    expects("N1 M115*39\n");
  }
};

TEST_CASE("A board that starts after it was greeted is greeted again") {
  Meeting talk;
  talk.is_greeted();
  talk.says("start");
  talk.says("Marlin 2.1.2");
  talk.expects("");
  talk.silence(700ms);

  talk.expects(kHello);
  talk.goes_on();
}

TEST_CASE("Garbage that eats the ok of the greeting costs another greeting") {
  Meeting talk;
  talk.is_greeted();
  talk.sender.receive("\x80\x00\xfe~\x1b[2J\x8fk\n"s, talk.now);
  talk.silence(6s);
  talk.expects("");
  talk.silence(200ms);

  talk.expects(kHello);
  talk.goes_on();
}

TEST_CASE("Garbage before the greeting and in it does no harm to the next") {
  Meeting talk;
  talk.expects("");
  talk.sender.receive("\xff\xff\x00\xfe garbage without an end"s, talk.now);
  talk.silence(2500ms);
  talk.expects(kHello);
  talk.says("ok");  // glued to the garbage
  talk.silence(6s);
  talk.expects("");
  talk.silence(200ms);
  talk.expects(kHello);

  talk.goes_on();
}

bool wants_reset(Sender& sender) {
  const auto events = sender.take_events();
  return std::ranges::count(events, SenderEvent(ResetWanted{})) > 0;
}

TEST_CASE("A board that says nothing at all is to be reset, once, and heard out") {
  Meeting talk;
  talk.is_greeted();
  talk.silence(6s);
  talk.expects("");
  CHECK_FALSE(wants_reset(talk.sender));
  talk.silence(200ms);
  talk.expects(kHello);

  talk.silence(6s);
  talk.expects("");

  CHECK(wants_reset(talk.sender));
  talk.silence(2400ms);
  talk.expects("");
  talk.says("start");
  talk.silence(700ms);
  talk.expects(kHello);
  talk.silence(6s);
  talk.expects("");
  CHECK_FALSE(wants_reset(talk.sender));
}

TEST_CASE("A board that says anything is not reset for answering nothing") {
  Meeting talk;
  talk.is_greeted();
  talk.says("echo:busy: processing");
  while (talk.sender.state() == SenderState::kGreeting && talk.now < 10min) {
    (void)talk.sender.take_output(talk.now);
    talk.silence(20ms);
  }

  CHECK(talk.sender.state() == SenderState::kLost);
  CHECK_FALSE(wants_reset(talk.sender));
}

// The wrong baud rate: noise without an end.
TEST_CASE("Pages of noise are told from a printer, in bounded time and memory") {
  Meeting talk;
  Rng rng(5);
  std::size_t hellos = 0;
  while (talk.sender.state() == SenderState::kGreeting && talk.now < 10min) {
    hellos += talk.sender.take_output(talk.now).empty() ? 0U : 1U;
    std::string noise(200, ' ');
    for (char& byte : noise) byte = static_cast<char>(rng.below(256));
    talk.sender.receive(noise, talk.now);
    talk.silence(20ms);
  }

  CHECK(talk.sender.state() == SenderState::kLost);
  CHECK_THAT(talk.sender.reason(), Catch::Contains("the baud rate"));
  CHECK(hellos <= Sender::kGreetingAttempts + 1);
}

TEST_CASE("Runs of any byte in what a printer says are no more than unreadable") {
  for (int byte = 0; byte < 256; ++byte) {
    INFO(byte);
    Talk talk;
    talk.greet();
    talk.prints(3, "G1 X1");
    talk.sender.receive(std::string(5000, static_cast<char>(byte)), talk.now);
    talk.says("");
    talk.says("Error:unit \x94 moved by 1\xb0");

    CHECK(talk.sender.state() == SenderState::kPrinting);
  }
}

}  // namespace
}  // namespace slipstick
