#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "drivers/marlin/safe_stop.h"
#include "drivers/marlin/sender.h"
#include "tests/support/faulty_wire.h"
#include "tests/support/marlin_model.h"

namespace slipstick {

/// The lines of `executed` that are the job's: without the sender's own questions and its safe end.
inline std::vector<std::string> job_lines(const std::vector<std::string>& executed) {
  std::vector<std::string> kept;
  for (const std::string& line : executed) {
    const bool safe_end =
        line == "M108" || std::ranges::find(kSafeStopLines, line) != kSafeStopLines.end();
    if (line != "M105" && line != "M114" && line != "M115" && !line.starts_with("M155") &&
        !safe_end) {
      kept.push_back(line);
    }
  }
  return kept;
}

/// A sender, a faulty wire and a model printer under one virtual clock.
class Voyage {
 public:
  struct Options {
    MarlinModelOptions printer = {};
    WireFaults down = {};  ///< Host to printer.
    WireFaults up = {};
    SenderOptions sender = {};
  };

  Voyage(const Options& options, std::uint64_t seed)
      : sender_(options.sender),
        printer_(options.printer, seed),
        down_(options.down, seed * 3 + 1),
        up_(options.up, seed * 3 + 2) {}

  Sender& sender() { return sender_; }
  MarlinModel& printer() { return printer_; }
  Moment now() const { return now_; }
  std::uint64_t faults() const { return down_.faults() + up_.faults(); }

  void unplug(bool out) {
    down_.cut(out);
    up_.cut(out);
  }
  void mute() { up_.cut(true); }
  bool unplugged() const { return down_.is_cut(); }
  /// What is on its way to the host is lost.
  void lose_replies() {
    (void)printer_.speak(now_);
    (void)up_.take(Moment::max());
  }

  /// Prints `job`, calling `meanwhile` before each turn; returns how it ended, or the state it was
  /// in after `kMaxSteps`.
  template <typename Meanwhile>
  SenderState print(const std::vector<std::string>& job, const Meanwhile& meanwhile) {
    std::size_t next = 0;
    for (int step = 0; step < kMaxSteps && !ended(); ++step) {
      while (next < job.size() && sender_.wants_line()) sender_.push(*Line::make(job[next++]));
      if (next == job.size()) sender_.end_of_job();
      take_turn();
      meanwhile();
    }
    return sender_.state();
  }

  SenderState print(const std::vector<std::string>& job) {
    return print(job, [] {});
  }

  /// Lets the sender say its last words and the printer do what it has heard.
  void come_to_rest() {
    const Moment until = now_ + std::chrono::minutes(1);
    for (int step = 0; step < kMaxSteps && now_ < until; ++step) take_turn();
  }

  /// Both sides say what they have to, or time passes until one of them has something.
  void take_turn() {
    const std::string sent = sender_.take_output(now_);
    printer_.announce(sent);
    down_.push(sent, now_);
    const std::string reached = down_.take(now_);
    if (!reached.empty()) printer_.hear(reached, now_);
    up_.push(printer_.speak(now_), now_);
    const std::string heard = up_.take(now_);
    if (!heard.empty()) return sender_.receive(heard, now_);
    Moment next = now_ + kStep;
    for (const auto at :
         {sender_.wakeup(), printer_.next_event(), down_.next_at(), up_.next_at()}) {
      if (at) next = std::min(next, *at);
    }
    now_ = std::max(now_ + Moment(1), next);
  }

 private:
  static constexpr int kMaxSteps = 200'000;
  static constexpr Moment kStep = std::chrono::seconds(10);

  bool ended() const {
    const SenderState state = sender_.state();
    return state == SenderState::kDone || state == SenderState::kLost ||
           state == SenderState::kHalted;
  }

  Sender sender_;
  MarlinModel printer_;
  FaultyWire down_;
  FaultyWire up_;
  Moment now_{};
};

}  // namespace slipstick
