#include <catch2/catch.hpp>

#include "tests/support/marlin_model_voyage.h"

namespace slipstick {
namespace {

const std::string kText = "G1 X1.5 E.4";
const std::vector<std::string> kJob{"G28", "M83", kText, "M104 S1"};

/// A printer that is handed `damaged` instead of the line with `kText`, once; the rest is clean.
class Substitution {
 public:
  explicit Substitution(MarlinModelOptions options) : printer_(options, 1) {}

  SenderState print(const std::string& damaged) {
    std::size_t next = 0;
    for (int step = 0; step < 5000; ++step) {
      while (next < kJob.size() && sender_.wants_line()) sender_.push(*Line::make(kJob[next++]));
      if (next == kJob.size()) sender_.end_of_job();
      std::string sent = sender_.take_output(now_);
      printer_.announce(sent);
      if (!replaced_ && sent.find(kText) != std::string::npos) {
        replaced_ = true;
        sent = damaged;
      }
      printer_.hear(sent, now_);
      const std::string said = printer_.speak(now_);
      now_ += std::chrono::milliseconds(2);
      sender_.receive(said, now_);
      if (said.empty()) pass_time();
      const SenderState state = sender_.state();
      if (state == SenderState::kDone || state == SenderState::kLost) return state;
    }
    return sender_.state();
  }

  std::vector<std::string> executed() const { return job_lines(printer_.executed()); }
  const Sender& sender() const { return sender_; }

 private:
  void pass_time() {
    Moment next = sender_.wakeup().value_or(now_ + std::chrono::milliseconds(100));
    if (const auto event = printer_.next_event()) next = std::min(next, *event);
    now_ = std::max(now_ + Moment(1), next);
  }

  Sender sender_;
  MarlinModel printer_;
  Moment now_{};
  bool replaced_ = false;
};

void check_exact(MarlinModelOptions options, const std::string& damaged) {
  Substitution line(options);
  const SenderState end = line.print(damaged);
  INFO("damaged to: " << Catch::StringMaker<std::string>::convert(damaged) << " reason "
                      << line.sender().reason());
  REQUIRE(end == SenderState::kDone);
  REQUIRE(line.executed() == kJob);
}

constexpr MarlinModelOptions kNewest{.undetected = Undetected::kObeyGhosts};
constexpr MarlinModelOptions kWithoutOk{
    .swallows_duplicates = false, .ok_after_resend = false, .undetected = Undetected::kObeyGhosts};

std::string clean_line() {
  // M110, M115 and M155, then the job.
  return frame(10'005, kText);
}

TEST_CASE("Any byte of a line changed to any other: the job is executed once and in order") {
  const std::string clean = clean_line();
  const MarlinModelOptions options = GENERATE(kNewest, kWithoutOk);
  for (std::size_t at = 0; at < clean.size(); ++at) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string damaged = clean;
      damaged[at] = static_cast<char>(byte);
      check_exact(options, damaged);
    }
  }
}

TEST_CASE("Any byte lost, and a newline put anywhere: the job is executed once and in order") {
  const std::string clean = clean_line();
  const MarlinModelOptions options = GENERATE(kNewest, kWithoutOk);
  for (std::size_t at = 0; at < clean.size(); ++at) {
    check_exact(options, std::string(clean).erase(at, 1));
    check_exact(options, std::string(clean).insert(at, 1, '\n'));
  }
}

TEST_CASE("A tail that was obeyed is counted and not sent again") {
  // The model flushes the tail or not, by its seed; here it does not.
  std::string damaged = clean_line();
  damaged[damaged.find(' ')] = '\n';
  Substitution line(kNewest);

  REQUIRE(line.print(damaged) == SenderState::kDone);

  CHECK(line.executed() == kJob);
  CHECK(line.sender().counters().ghosts <= 1);
}

}  // namespace
}  // namespace slipstick
