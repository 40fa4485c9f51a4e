#include <fmt/format.h>

#include "drivers/marlin/repeatable.h"
#include "drivers/marlin/sender.h"

// Damage may turn a byte into a newline. The head of the line is refused for want of a checksum,
// and a tail that is a command in itself is obeyed, without number or checksum: `N12` and `G1 X10`.
// Sent again, the move would be made twice. With one line in flight every `ok` beyond that of the
// request and those of unknown commands is the ghost's.

namespace slipstick {

bool Sender::may_be_ghost(const Drain& seen) const {
  if (!seen.refused || seen.mismatch || greeting_) return false;
  // The line in flight, or one thought taken because of an ok that answered something else.
  const LineNumber from = sure_ + 1;
  for (LineNumber number = from; number < cursor_; ++number) {
    if (lines_.has(number) && !is_repeatable(lines_.at(number).text)) return true;
  }
  return false;
}

bool Sender::settle_ghost(const Drain& seen, LineNumber number) {
  if (!may_be_ghost(seen) || number >= cursor_) return true;
  if (is_repeatable(lines_.at(number).text)) return true;
  // Marlin 2.0.8 alone, not 2.0.8.1 and later, sends no ok behind its request.
  const int expected = firmware_.starts_with("Marlin 2.0.8 ") ? 0 : 1;
  const int ghosts = seen.oks - expected - seen.unknown;
  const bool taken_once = number < cursor_ - 1;
  if (ghosts == 0 && !seen.garbled && !taken_once) return true;
  if (ghosts == 1 && !seen.garbled && !taken_once) {
    lines_.settle(number);
    ++counters_.ghosts;
    return true;
  }
  give_up(SenderState::kLost,
          fmt::format("line {} ({}) was damaged on its way, and whether the printer obeyed part of "
                      "it cannot be told; check the cable and start again",
                      number, lines_.at(number).text));
  return false;
}

}  // namespace slipstick
