#include <algorithm>
#include <utility>
#include <variant>

#include "drivers/marlin/patience.h"
#include "drivers/marlin/sender.h"

namespace slipstick {
namespace {

/// An M105 is answered at once by a printer that answers something else.
constexpr Moment kSettle = std::chrono::seconds(1);

}  // namespace

void Sender::handle(const Reply& reply, Moment now) {
  std::visit([&](const auto& said) { on(said, now); }, reply);
  if (listening_until_ && booting_) listen_to_banner(now);
}

bool Sender::may_answer(const Ok& ok, LineNumber number) const {
  if (ok.line && *ok.line != number) return false;
  // The temperatures tell whose answer it is. Anything may stand behind the ok of an M105, so that
  // damaged temperatures still count.
  const bool query = is_command(lines_.at(number).text, "M105");
  return query ? !ok.bare : !ok.temperatures;
}

void Sender::on(const Ok& ok, Moment now) {
  if (ok.temperatures) tell(TemperaturesSeen{*ok.temperatures});
  if (const auto number = answered(ok)) {
    // Perhaps it answers what noise made of the line: nothing of the job goes out before that is
    // known, or noise could make an unnumbered command of the next line too, and of that alone.
    const bool doubtful = odd_text_ && !greeting_ && ok.bare;
    return doubtful ? ask_for_truth(now) : acknowledge(*number, now);
  }
  if (over()) printer_stopped_ = false;  // whatever it said
  if (over() || listening_until_) return;
  if (!drain_) ++counters_.surplus_oks;
  if (!drain_) ++loose_ends_;
  // The printer is awake: an M105 that is not answered by now was lost.
  if (outstanding_) deadline_ = std::min(deadline_, now + kSettle);
}

void Sender::acknowledge(LineNumber number, Moment now) {
  if (number == first_ && odd_text_) return greet_again(now);
  accepted_ = number;
  last_heeded_ = now;
  busy_with_.clear();
  counters_.lines_acknowledged = lines_.at(number).job_lines;
  const bool several = std::exchange(several_, several_ && number + 1 < cursor_);
  outstanding_ = several_ ? std::optional(number + 1) : std::nullopt;
  if (several_) deadline_ = now + patience_;
  proven_ = odd_text_ ? 0 : proven_ + 1;
  if (odd_text_) {
    // Perhaps this ok answers what noise made of the line; the next line will tell.
    last_clean_ = -2;
  } else if (several || unproven_) {
    prove(number);
  } else {
    if (last_clean_ == number - 1 && number - 1 > sure_) trust(number - 1);
    last_clean_ = number;
    odd_requests_ = 0;
  }
  const bool late_answers_possible = probes_ > 0 || number == first_ || number == closing_;
  probes_ = 0;
  if (late_answers_possible) start_drain(now);
}

void Sender::on(const Resend& resend, Moment now) {
  if (over() || listening_until_) return;
  if (!drain_) start_drain(now);
  drain_->refused = true;
  proven_ = 0;
  if (resend.line) drain_->requested = resend.line;
}

void Sender::on(const LineError& error, Moment now) {
  if (over() || listening_until_) return;
  if (!drain_) start_drain(now);
  drain_->refused = true;
  proven_ = 0;
  drain_->mismatch = error.text.starts_with("Error:checksum mismatch, Last Line: ");
  if (error.last_line) drain_->last_line = error.last_line;
}

void Sender::on(const Fatal& fatal, Moment /*now*/) {
  last_words_left_ = 0;
  printer_stopped_ = true;
  if (over()) return tell(MessageSeen{fatal.text});
  give_up(SenderState::kHalted, "the printer stopped itself: " + fatal.text);
}

void Sender::on(const ErrorText& error, Moment /*now*/) {
  tell(MessageSeen{error.text});
}

void Sender::on(const Busy& busy, Moment now) {
  stay_patient(now);
  // Once: it comes every two seconds. At work is what a printer is expected to be.
  if (busy.reason == busy_with_) return;
  busy_with_ = busy.reason;
  if (busy.reason != "processing") tell(MessageSeen{"busy: " + busy.reason});
}

void Sender::on(const UnknownCommand& command, Moment /*now*/) {
  odd_text_ = true;
  if (!drain_) ++loose_ends_;
  tell(MessageSeen{command.text});
}

void Sender::on(const Echo& echo, Moment /*now*/) {
  tell(MessageSeen{echo.text});
}

void Sender::on(const Action& action, Moment /*now*/) {
  tell(ActionSeen{action.text});
}

void Sender::on(const Temperatures& temperatures, Moment now) {
  // Reports come by themselves while an ok is lost; only those of a heating command prove that it
  // runs.
  if (temperatures.waiting) stay_patient(now);
  // The sender that began a session which this one goes on with may have told it to.
  if (options_.kept && !asked_for_temperatures()) reporting_ = true;
  tell(TemperaturesSeen{temperatures});
}

bool Sender::asked_for_temperatures() const {
  if (!outstanding_) return false;
  return patience_ == kBlockingPatience || lines_.at(*outstanding_).text == "M105";
}

void Sender::on(const Wait& /*wait*/, Moment now) {
  // Nothing is left in the printer, and what was sent has had time to get there.
  if (outstanding_ && now - sent_at_ >= kSettle) deadline_ = now;
}

void Sender::on(const Unknown& unknown, Moment /*now*/) {
  odd_text_ = true;
  if (!drain_) ++loose_ends_;
  ++counters_.unreadable;
  tell(AnswerSeen{unknown.text});
}

void Sender::stay_patient(Moment now) {
  last_heeded_ = now;
  if (outstanding_) deadline_ = std::max(deadline_, now + patience_);
}

}  // namespace slipstick
