#include <fmt/format.h>

#include <algorithm>

#include "drivers/marlin/repeatable.h"
#include "drivers/marlin/sender.h"

// Damage may turn a byte into a newline, or eat the number. Of "N10012" and "G1 X10*33" the printer
// refuses the first for want of a checksum and obeys the second, which has none to be held against.
// Sent again, the move would be made twice. So a refused line is sent again at once only if it was
// refused whole; otherwise the printer is asked where it is, with numbers of their own put before
// the line, until two reports in a row agree.

namespace slipstick {
namespace {

/// Executing the line again moves nothing by more than a report could tell: all is known.
bool stays(const Position& before, const Position& after) {
  const auto known = [](const auto& axis) { return axis.has_value(); };
  return std::ranges::all_of(after, known) && !tells_apart(before, after);
}

}  // namespace

void Sender::doubt(LineNumber next, const Refusal& refusal) {
  if (doubt_ && next <= doubt_->line) return;
  doubt_.reset();
  // Of the lines behind, tails may have been obeyed however whole the refused one was.
  if (refusal.several) next = first_move_from(next);
  if (next >= cursor_ || (refusal.whole && !refusal.several)) return;
  const SentLines::Entry& line = lines_.at(next);
  if (is_repeatable(line.text)) return;
  const Position before = lines_.has(next - 1) ? lines_.at(next - 1).after : Position();
  const bool never_came = refusal.lost && !refusal.several;
  if (tells_apart(before, line.after)) {
    doubt_ = Doubt{.line = next, .questions = 0, .report = {}};
  } else if (!never_came && !stays(before, line.after)) {
    give_up(SenderState::kLost,
            fmt::format("line {} ({}) was damaged on its way, and whether the printer obeyed part "
                        "of it cannot be told; check the cable and start again",
                        next, line.text));
  }
}

bool Sender::ask_about_doubt() {
  if (++doubt_->questions > kMaxQuestions) {
    give_up(SenderState::kLost,
            fmt::format("line {} ({}) was damaged on its way, and where the printer says it is "
                        "does not tell whether it obeyed part of it; check the cable and start "
                        "again",
                        doubt_->line, lines_.at(doubt_->line).text));
    return false;
  }
  tell(QuestionInserted{doubt_->line});
  lines_.insert_question(doubt_->line, "M114");
  if (closing_ && *closing_ >= doubt_->line) ++*closing_;
  ++doubt_->line;
  return true;
}

void Sender::on(const PositionReport& report, Moment /*now*/) {
  if (!outstanding_ || lines_.at(*outstanding_).owner != LineOwner::kSender) {
    const Position& at = report.position;
    tell(AnswerSeen{fmt::format("X:{:.2f} Y:{:.2f} Z:{:.2f} E:{:.2f}", at[0].value_or(0),
                                at[1].value_or(0), at[2].value_or(0), at[3].value_or(0))});
  }
  if (!doubt_ && outstanding_ && lines_.at(*outstanding_).text == "M114") {
    const bool confirmed = learnt_ == report.position;
    learnt_ = report.position;
    if (!confirmed) return;
    lines_.learn(*outstanding_, report.position);
    position_requests_ = 0;
  }
  if (!doubt_ || doubt_->questions == 0) return;
  const Executed said =
      executed(report.position, lines_.at(doubt_->line - 1).after, lines_.at(doubt_->line).after);
  const bool confirmed = doubt_->report == report.position;
  doubt_->report = report.position;
  if (!confirmed || said == Executed::kUnclear) return;
  if (said == Executed::kYes) {
    lines_.settle(doubt_->line);
    ++counters_.ghosts;
  }
  doubt_.reset();
}

}  // namespace slipstick
