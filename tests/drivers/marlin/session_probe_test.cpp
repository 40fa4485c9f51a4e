#include "drivers/marlin/session_probe.h"

#include <catch2/catch.hpp>

namespace slipstick {
namespace {

using namespace std::chrono_literals;
using State = SessionProbe::State;

constexpr std::string_view kPlace = "X:10.00 Y:20.00 Z:0.30 E:1.00 Count X:800 Y:1600 Z:120\nok\n";

// A probe and a printer played by the test.
struct Inquiry {
  SessionProbe probe{999'999};
  Moment now{};

  std::string asked() {
    for (int i = 0; i < 1000; ++i) {
      const std::string question = probe.take_output(now);
      if (!question.empty() || probe.state() != State::kAsking) return question;
      now = std::max(now + 1ms, probe.wakeup());
    }
    return {};
  }
  void says(std::string_view text) { probe.receive(text, now); }
  void refuses(int last) {
    says("Error:Line Number is not Last Line Number+1, Last Line: " + std::to_string(last) +
         "\nResend: " + std::to_string(last + 1) + "\nok\n");
  }
};

TEST_CASE("A printer that counts on is asked for its last line and its place, each twice") {
  Inquiry inquiry;
  const std::string count = "\n" + frame(999'999, "M105");

  CHECK(inquiry.asked() == count);
  CHECK(inquiry.now >= SessionProbe::kBannerWait);
  inquiry.refuses(10'123);
  CHECK(inquiry.asked() == count);
  inquiry.refuses(10'123);
  CHECK(inquiry.asked() == "\nM114\n");
  inquiry.says(kPlace);
  CHECK(inquiry.asked() == "\nM114\n");
  inquiry.says(kPlace);
  CHECK(inquiry.asked().empty());

  REQUIRE(inquiry.probe.state() == State::kFound);
  CHECK(inquiry.probe.found().last == 10'123);
  CHECK(inquiry.probe.found().position == Position{10.0, 20.0, 0.3, 1.0});
}

TEST_CASE("Answers that are damaged, or differ, count for nothing") {
  Inquiry inquiry;
  for (const char* answer :
       {"Error:x, Last Line: 10\nok\n", "Resend: 11\nok\n", "Error:x, Last Line: 10\nResend: 12\n",
        "Error:x, Last Line: 10\nResend: 11\n", "Error:x, Last Line: 12\nResend: 13\n",
        "Error:x, Last Line: 1?\nResend: 13\n", "Error:x, Last Line: 12\nResend: 13\n"}) {
    INFO(answer);
    CHECK(inquiry.asked() == "\n" + frame(999'999, "M105"));
    inquiry.says(answer);
  }
}

TEST_CASE("A printer that says that it has started was reset, at any time") {
  const bool late = GENERATE(false, true);
  Inquiry inquiry;
  if (late) (void)inquiry.asked();

  inquiry.says("start\n");

  CHECK(inquiry.asked().empty());
  CHECK(inquiry.probe.state() == State::kReset);
}

TEST_CASE("A printer that is busy is waited for, one that is silent is given up") {
  Inquiry inquiry;
  for (int i = 0; i < 100; ++i) {
    REQUIRE_FALSE(inquiry.asked().empty());
    inquiry.says("echo:busy: processing\n");
  }
  CHECK(inquiry.probe.state() == State::kAsking);

  int questions = 0;
  while (!inquiry.asked().empty()) ++questions;

  CHECK(inquiry.probe.state() == State::kSilent);
  CHECK(questions <= 31);
}

TEST_CASE("A printer that talks of other things is not asked for ever") {
  Inquiry inquiry;
  int questions = 0;
  while (!inquiry.asked().empty()) {
    ++questions;
    inquiry.says("T:20.0 /0.0 B:20.0 /0.0\n");
  }

  CHECK(inquiry.probe.state() == State::kSilent);
  CHECK(questions == SessionProbe::kQuestionsMax);
}

}  // namespace
}  // namespace slipstick
