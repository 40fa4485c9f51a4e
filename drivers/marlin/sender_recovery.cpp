#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drivers/marlin/patience.h"
#include "drivers/marlin/sender.h"

// Finding out where the printer stands. Two rules carry it: a number never means another line, so
// sending the wrong number is harmless; and a number higher than the printer expects is answered at
// once with the one it does expect, while one of the last two (Marlin 2.1.2 and later) is met with
// silence.

namespace slipstick {
namespace {

/// Several round trips at 115200 baud, and the interval of a USB adapter's latency timer.
constexpr Moment kQuiet = std::chrono::milliseconds(60);
constexpr Moment kMaxDrain = std::chrono::seconds(1);
/// With this probe a silence is told: 42 s after a line that is quick.
constexpr int kAlarmProbes = 3;

}  // namespace

void Sender::start_drain(Moment now) {
  drain_ = Drain{.began = now, .requested = {}, .last_line = {}, .several = several_ || unproven_};
}

Moment Sender::drain_end() const {
  return std::min(std::max(drain_->began, last_heard_) + kQuiet, drain_->began + kMaxDrain);
}

void Sender::finish_drain(Moment now) {
  const Drain seen = *drain_;
  drain_.reset();
  if (!seen.refused) return;
  const auto refused = std::exchange(outstanding_, std::nullopt);
  several_ = false;
  const bool silent = probes_ > 0 && loose_ends_ == 0;
  probes_ = 0;
  const auto by_error = seen.last_line ? std::optional(*seen.last_line + 1) : std::nullopt;
  const bool request_fits = can_be_next(seen.requested);
  const bool error_fits = can_be_next(by_error);
  if (!request_fits && !error_fits) {
    return on_odd_request(seen.requested ? seen.requested : by_error, now);
  }
  // Two witnesses that agree are believed for good. When they disagree one is damaged, and the
  // higher number is the better guess: if it is wrong the printer says so at once.
  const LineNumber next = !error_fits     ? *seen.requested
                          : !request_fits ? *by_error
                                          : std::max(*seen.requested, *by_error);
  if (seen.requested == by_error && next - 1 > sure_) trust(next - 1);
  odd_requests_ = 0;
  doubt(next, {.whole = seen.mismatch && next == refused,
               .lost = silent && accepted_ < next,
               .several = seen.several});
  if (!over()) rewind(next);
}

bool Sender::can_be_next(std::optional<LineNumber> number) const {
  if (!number || *number <= sure_) return false;
  return lines_.has(*number) || *number == lines_.highest() + 1;
}

void Sender::rewind(LineNumber number) {
  if (++rewinds_ > kMaxRewinds) {
    return give_up(
        SenderState::kLost,
        fmt::format("the printer refused line {} {} times; the cable or the supply is bad", number,
                    kMaxRewinds));
  }
  if (cursor_ > number) counters_.resends += static_cast<std::uint64_t>(cursor_ - number);
  cursor_ = number;
  accepted_ = number - 1;
  last_clean_ = -2;
  tell(ResendSeen{number});
}

void Sender::on_odd_request(std::optional<LineNumber> number, Moment now) {
  if (greeting_) return greet_again(now);
  if (++odd_requests_ < kMaxOddRequests) return probe(now);
  const std::string asked = number ? std::to_string(*number) : "?";
  give_up(
      SenderState::kLost,
      fmt::format("the printer asks for line {} though it took {}: it was reset, and its position "
                  "is lost; clear the bed and start again",
                  asked, sure_));
}

void Sender::on_silence(Moment now) {
  if (greeting_) return greet_again(now);
  if (probes_ < kMaxProbes) {
    if (++probes_ == kAlarmProbes) {
      tell(MessageSeen{"the printer does not answer; its heaters may be on"});
    }
    ++counters_.probes;
    probe(now);
    deadline_ = now + patience_ * (1 << probes_);
    tell(ProbeSent{*outstanding_});
  } else if (now - last_heard_ >= kAliveWindow && !may_be_blocked()) {
    give_up(SenderState::kLost, fmt::format("the printer has not answered since line {}; check the "
                                            "cable and the power",
                                            accepted_));
  } else if (now - last_heeded_ >= kDeafMax) {
    give_up(SenderState::kLost, fmt::format("the printer still talks, but has obeyed nothing since "
                                            "line {}; switch it off",
                                            accepted_));
  } else {
    deadline_ = now + kAliveWindow;
  }
}

bool Sender::may_be_blocked() const {
  for (LineNumber number = std::max(sure_, first_ - 1) + 1; number <= accepted_; ++number) {
    if (lines_.has(number) && is_blocking(lines_.at(number).text)) return true;
  }
  return false;
}

void Sender::ask_for_truth(Moment now) {
  ++loose_ends_;
  ++probes_;
  ++counters_.probes;
  probe(now);
  tell(ProbeSent{*outstanding_});
}

void Sender::probe(Moment now) {
  cursor_ = bind("M105", LineOwner::kSender);
  transmit(now);
}

}  // namespace slipstick
