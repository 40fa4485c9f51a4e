#include "drivers/marlin/sender.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "drivers/marlin/patience.h"
#include "drivers/marlin/safe_stop.h"

namespace slipstick {
namespace {

/// For printers without reports of their own.
constexpr Moment kPollInterval = std::chrono::seconds(10);
/// A firmware that does not report positions is not asked for ever.
constexpr int kPositionRequests = 10;
constexpr Moment kLastWordsInterval = std::chrono::milliseconds(250);

}  // namespace

Sender::Sender(SenderOptions options) : options_(options) {
  SLIPSTICK_CHECK(options.first_number >= 0);
  SLIPSTICK_CHECK(options.report_seconds >= 1 && options.report_seconds <= 60);
  SLIPSTICK_CHECK(options.window >= 0 && options.window <= kWindowMax);
  if (!options.kept) return;
  greeting_ = false;
  first_ = accepted_ = sure_ = options.kept->last;
  cursor_ = first_ + 1;
  lines_ = SentLines(cursor_, options.kept->place);
}

void Sender::receive(std::string_view bytes, Moment now) {
  if (!bytes.empty()) {
    last_heard_ = now;
    heard_ = true;
  }
  splitter_.feed(bytes);
  while (const auto line = splitter_.next()) handle(parse_reply(*line), now);
}

std::string Sender::take_output(Moment now) {
  advance(now);
  return std::exchange(output_, {});
}

std::optional<Moment> Sender::wakeup() const {
  if (over()) {
    return last_words_left_ > 0 ? std::optional(next_last_words_) : std::nullopt;
  }
  if (!started_) return Moment::zero();
  if (listening_until_) return listening_until_;
  if (drain_) return drain_end();
  if (outstanding_) return deadline_;
  return reports_ ? std::nullopt : std::optional(next_poll_);
}

SenderState Sender::state() const {
  if (over()) return *fate_;
  if (greeting_) return SenderState::kGreeting;
  if (done_) return SenderState::kDone;
  if (drain_ || probes_ > 0 || cursor_ <= lines_.highest()) return SenderState::kResending;
  if (outstanding_ && patience_ == kBlockingPatience) return SenderState::kWaiting;
  const bool begun = counters_.lines_sent > 0 || queued_ || ended_;
  return begun ? SenderState::kPrinting : SenderState::kReady;
}

bool Sender::wants_line() const {
  return !over() && !queued_ && (!ended_ || done_);
}

void Sender::push(Line line, LineOwner owner) {
  SLIPSTICK_CHECK(wants_line());
  ended_ = done_ = false;
  closing_.reset();
  queued_for_ = owner;
  queued_ = std::move(line);
}

void Sender::end_of_job() {
  if (!done_) ended_ = true;
}

void Sender::stop() {
  if (over()) return;
  queued_.reset();
  stop_lines_.clear();
  for (const std::string_view text : kSafeStopLines) stop_lines_.push_back(*Line::make(text));
  std::ranges::reverse(stop_lines_);
  closing_.reset();
  ended_ = true;
  done_ = false;
  const bool waiting = outstanding_ && patience_ == kBlockingPatience;
  if (waiting) output_ += kEndWait;
}

void Sender::emergency_stop() {
  give_up(SenderState::kHalted, "emergency stop; reset the printer to go on");
  last_words_ = kEmergencyStop;
  last_words_left_ = kEmergencyStops;
  next_last_words_ = Moment::zero();
}

void Sender::abandon(std::string reason) {
  give_up(SenderState::kLost, std::move(reason));
}

std::vector<SenderEvent> Sender::take_events() {
  return std::exchange(events_, {});
}

void Sender::advance(Moment now) {
  if (!over()) step(now);
  if (over()) say_last_words(now);
}

void Sender::step(Moment now) {
  if (!started_) {
    started_ = true;
    last_heard_ = now;
    if (greeting_) listen(now, options_.banner_wait);
  }
  if (listening_until_) {
    if (now >= *listening_until_) say_hello(now);
    return;
  }
  if (drain_) {
    if (now < drain_end()) return;
    finish_drain(now);
  }
  if (over() || listening_until_) return;
  if (!outstanding_) return send_next(now);
  if (now >= deadline_) return on_silence(now);
  if (has_room_behind()) send_next(now);
}

void Sender::send_next(Moment now) {
  if (closing_ && accepted_ >= *closing_) done_ = true;
  if (doubt_ && cursor_ == doubt_->line && !ask_about_doubt()) return;
  if (cursor_ > lines_.highest() && !bind_next(now)) return;
  transmit(now);
}

bool Sender::bind_next(Moment now) {
  if (greeting_ && bind_greeting(now)) return true;
  if (greeting_) return false;
  if (!stop_lines_.empty()) {
    bind(stop_lines_.back().text(), LineOwner::kSender);
    stop_lines_.pop_back();
  } else if (reports_ && !reporting_ && !ended_) {
    ask_for_reports(options_.report_seconds);
  } else if (!reports_ && now >= next_poll_) {
    next_poll_ = now + kPollInterval;
    bind("M105", LineOwner::kSender);
  } else if (queued_ && lines_.lost() && position_requests_ < kPositionRequests) {
    ++position_requests_;
    bind("M114", LineOwner::kSender);
  } else if (queued_ && wants_proof()) {
    proof_ = bind("M105", LineOwner::kSender);
  } else if (queued_) {
    bind(queued_->text(), queued_for_);
    queued_.reset();
    if (queued_for_ == LineOwner::kJob) ++counters_.lines_sent;
  } else if (ended_ && reporting_) {
    ask_for_reports(0);
  } else if (ended_ && !closing_) {
    closing_ = bind("M105", LineOwner::kSender);
  } else {
    return false;
  }
  return true;
}

// Not for ever: a firmware may stand still when nobody reads what it reports.
void Sender::ask_for_reports(int seconds) {
  reporting_ = seconds > 0;
  bind("M155 S" + std::to_string(seconds), LineOwner::kSender);
}

LineNumber Sender::bind(std::string text, LineOwner owner) {
  if (owner != LineOwner::kJob)
    tell(LineBound{lines_.highest() + 1, owner == LineOwner::kHost ? text : std::string()});
  return lines_.bind(std::move(text), owner);
}

void Sender::trust(LineNumber number) {
  sure_ = number;
  rewinds_ = 0;
  if (lines_.has(number)) counters_.lines_sure = lines_.at(number).job_lines;
}

void Sender::transmit(Moment now) {
  const std::string& text = lines_.at(cursor_).text;
  output_ += frame(cursor_, text);
  const bool behind = outstanding_ && probes_ == 0;
  if (probes_ == 0) {
    patience_ = patience_for(text);
    if (!behind) loose_ends_ = 0;
  }
  if (behind) {
    several_ = unproven_ = true;
    ++counters_.lines_behind;
  } else {
    outstanding_ = cursor_;
    odd_text_ = false;
  }
  sent_at_ = now;
  deadline_ = now + patience_;
  ++cursor_;
}

void Sender::say_last_words(Moment now) {
  if (last_words_left_ == 0 || now < next_last_words_) return;
  --last_words_left_;
  next_last_words_ = now + kLastWordsInterval;
  output_ += last_words_;
}

void Sender::tell(SenderEvent event) {
  if (events_.size() == kMaxEvents) {
    events_.erase(events_.begin());
    ++counters_.events_dropped;
  }
  events_.push_back(std::move(event));
}

void Sender::give_up(SenderState state, std::string reason) {
  if (over()) return;
  fate_ = state;
  reason_ = std::move(reason);
  output_.clear();
  tell(SenderStopped{reason_});
  if (state != SenderState::kLost) return;
  // A board that was reset has no targets, but one that merely could not be understood may be hot.
  last_words_ = numbered_safe_stop();
  last_words_left_ = kSafeStops;
  next_last_words_ = Moment::zero();
}

}  // namespace slipstick
