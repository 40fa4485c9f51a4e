#pragma once

#include <string>
#include <vector>

#include "drivers/marlin/sender.h"
#include "tests/support/marlin_model.h"

namespace slipstick {

/// A sender, a faulty wire and a model printer under one virtual clock.
class Voyage {
 public:
  struct Options {
    MarlinModelOptions printer = {};
    double damage_down = 0;  ///< Per byte, host to printer.
    double damage_up = 0;
    double lost_oks = 0;
  };

  Voyage(Options options, std::uint64_t seed)
      : printer_(options.printer, seed),
        down_(options.damage_down, 0, seed * 3 + 1),
        up_(options.damage_up, options.lost_oks, seed * 3 + 2) {}

  Sender& sender() { return sender_; }
  MarlinModel& printer() { return printer_; }
  Moment now() const { return now_; }
  std::uint64_t faults() const { return down_.faults() + up_.faults(); }

  /// Prints `job`; returns how it ended, or the state it was in after `kMaxSteps`.
  SenderState print(const std::vector<std::string>& job) {
    std::size_t next = 0;
    for (int step = 0; step < kMaxSteps; ++step) {
      while (next < job.size() && sender_.wants_line()) sender_.push(*Line::make(job[next++]));
      if (next == job.size()) sender_.end_of_job();
      take_turn();
      const SenderState state = sender_.state();
      if (state == SenderState::kDone || state == SenderState::kLost ||
          state == SenderState::kHalted) {
        return state;
      }
    }
    return sender_.state();
  }

  /// Both sides say what they have to, and time passes until one of them has more.
  void take_turn() {
    const std::string sent = sender_.take_output(now_);
    printer_.announce(sent);
    if (!sent.empty()) printer_.hear(down_.pass(sent), now_);
    const std::string said = printer_.speak(now_);
    if (!said.empty()) {
      now_ += kRoundTrip;
      return sender_.receive(up_.pass(said), now_);
    }
    Moment next = sender_.wakeup().value_or(now_ + kStep);
    if (const auto event = printer_.next_event()) next = std::min(next, *event);
    now_ = std::max(now_ + Moment(1), next);
  }

 private:
  static constexpr int kMaxSteps = 100'000;
  static constexpr Moment kRoundTrip = std::chrono::milliseconds(2);
  static constexpr Moment kStep = std::chrono::milliseconds(100);

  Sender sender_;
  MarlinModel printer_;
  FaultyWire down_;
  FaultyWire up_;
  Moment now_{};
};

/// The lines of `executed` that are the job's: without the sender's own questions.
inline std::vector<std::string> job_lines(const std::vector<std::string>& executed) {
  std::vector<std::string> kept;
  for (const std::string& line : executed) {
    if (line != "M105" && line != "M115" && !line.starts_with("M155")) kept.push_back(line);
  }
  return kept;
}

}  // namespace slipstick
