#include <algorithm>

#include "core/gcode/parse.h"
#include "drivers/marlin/sender.h"

// Several lines under way. A board whose buffers are never empty lets the wire be full all the
// time; one line at a time leaves it idle while an answer travels. What it costs: a line that is
// refused takes the ones behind it along, in pieces, and a piece that has lost its number is obeyed
// out of turn. So only moves go out behind others, their places known, so that the printer can be
// asked afterwards where it is; only a wire on which nothing odd was heard for a while is trusted;
// and an M105 now and then, whose answer cannot be taken for another's, proves what was taken, as
// mere oks may be lost or doubled.

namespace slipstick {
namespace {

bool is_plain_move(std::string_view text) {
  const auto command = parse_gcode(text);
  return command && command->letter() == 'G' && command->code() <= 3;
}

bool is_known(const Position& place) {
  return std::ranges::all_of(place, [](const auto& axis) { return axis.has_value(); });
}

}  // namespace

bool Sender::has_room_behind() const {
  const bool proved = options_.window > 0 && proven_ >= options_.proving;
  const bool quiet = !odd_text_ && !drain_ && !doubt_ && probes_ == 0 && loose_ends_ == 0;
  if (!proved || !quiet || greeting_ || !outstanding_ || cursor_ <= lines_.highest()) return false;
  if (!queued_ || !stop_lines_.empty() || !is_plain_move(queued_->text())) return false;
  if (!is_known(lines_.at(lines_.highest()).after)) return false;
  if (cursor_ - *outstanding_ >= kWindowLines) return false;
  std::size_t bytes = frame(cursor_, queued_->text()).size();
  for (LineNumber n = *outstanding_; n < cursor_; ++n) {
    const std::string& text = lines_.at(n).text;
    if (n != proof_ && !is_plain_move(text)) return false;
    bytes += frame(n, text).size();
  }
  return bytes <= static_cast<std::size_t>(options_.window);
}

/// While moves follow each other, now and then; and before what has to wait until they are done.
bool Sender::wants_proof() const {
  if (!unproven_) return false;
  return lines_.highest() - proof_ >= kProofEvery || !is_plain_move(queued_->text());
}

/// Mere oks come in turn; one with temperatures is the answer to an M105, and all before it were
/// taken though their own oks were lost.
std::optional<LineNumber> Sender::answered(const Ok& ok) const {
  if (!outstanding_ || drain_ || over()) return std::nullopt;
  if (may_answer(ok, *outstanding_)) return outstanding_;
  if (!several_ || ok.bare) return std::nullopt;
  for (LineNumber n = *outstanding_ + 1; n < cursor_; ++n) {
    const bool told = ok.line || (ok.temperatures && n == proof_);
    if (told && may_answer(ok, n)) return n;
  }
  return std::nullopt;
}

void Sender::prove(LineNumber number) {
  last_clean_ = -2;
  if (!is_command(lines_.at(number).text, "M105")) return;
  unproven_ = several_;
  if (number > sure_) trust(number);
}

LineNumber Sender::first_move_from(LineNumber number) const {
  while (number < cursor_ && !is_plain_move(lines_.at(number).text)) ++number;
  return number;
}

}  // namespace slipstick
