#include <algorithm>

#include "drivers/marlin/line_counting.h"
#include "drivers/marlin/sender.h"

// The greeting: listen for the banner, number the lines, ask for the name, arm the reports.
// Nothing here moves or heats, so on any trouble it simply begins again.

namespace slipstick {
namespace {

/// Boards say `echo:SD card ok` up to 0.6 s after their banner.
constexpr Moment kBootQuiet = std::chrono::milliseconds(700);
constexpr Moment kBootMax = std::chrono::seconds(15);
/// Long enough for all answers to the last attempt.
constexpr Moment kBetweenAttempts = std::chrono::milliseconds(200);
/// Attempts that a printer may leave without a byte before it is reset.
constexpr int kSilentAttempts = 2;
constexpr int kNameRequests = 3;
/// Lines of the greeting after which it has failed: each answered, none twice in a row without
/// noise.
constexpr LineNumber kGreetingLines = 16;

}  // namespace

void Sender::listen(Moment now, Moment patience) {
  listening_since_ = now;
  listening_until_ = now + patience;
  outstanding_.reset();
  drain_.reset();
}

void Sender::listen_to_banner(Moment now) {
  listening_until_ = std::min(now + kBootQuiet, listening_since_ + kBootMax);
}

void Sender::say_hello(Moment now) {
  listening_until_.reset();
  booting_ = false;
  first_ = options_.first_number;
  lines_ = SentLines(first_);
  cursor_ = first_;
  accepted_ = sure_ = first_ - 1;
  last_clean_ = -2;
  probes_ = rewinds_ = odd_requests_ = 0;
  name_requests_ = 0;
  reporting_ = false;
  doubt_.reset();
  tell(SessionBegun{first_});
  lines_.bind("M110 N" + std::to_string(first_), LineOwner::kSender);
  output_ += "\n";  // Ends whatever half a line stands in the printer's buffer.
  transmit(now);
}

void Sender::greet_again(Moment now) {
  if (++attempts_ >= kGreetingAttempts) {
    return give_up(SenderState::kLost,
                   "no Marlin answers; check the port, the baud rate and that the printer is on");
  }
  const bool mute = !heard_ && attempts_ == kSilentAttempts;
  if (mute) tell(ResetWanted{});
  listen(now, mute ? options_.banner_wait : kBetweenAttempts);
}

bool Sender::bind_greeting(Moment now) {
  if (lines_.highest() >= first_ + kGreetingLines) {
    greet_again(now);
    return false;
  }
  if (firmware_.empty() && name_requests_ < kNameRequests) {
    ++name_requests_;
    bind("M115", LineOwner::kSender);
  } else if (reports_ && !reporting_) {
    ask_for_reports(options_.report_seconds);
  } else if (sure_ < first_ + 1) {
    // Once the line after the M110 is surely taken, a request for it can only mean that the board
    // was reset.
    bind("M105", LineOwner::kSender);
  } else {
    greeting_ = false;
    next_poll_ = now;
    return false;
  }
  return true;
}

void Sender::on(const Start& start, Moment now) {
  if (over() && !start.cause.empty()) tell(MessageSeen{"the board started anew: " + start.cause});
  if (!greeting_) {
    return give_up(SenderState::kLost,
                   "the printer was reset during the job: its position is lost; clear the bed and "
                   "start again");
  }
  // Not during the first listening: that start is what it waits for.
  if (!listening_until_ && ++attempts_ >= kGreetingAttempts) return greet_again(now);
  if (!listening_until_) listen(now, kBootQuiet);
  booting_ = true;
}

void Sender::on(const FirmwareName& firmware, Moment /*now*/) {
  if (firmware.name == firmware_) return;
  firmware_ = firmware.name;
  tell(FirmwareSeen{firmware_});
  if (!greeting_ || counts_lines(firmware_)) return;
  give_up(
      SenderState::kLost,
      firmware_ + " does not count lines: what is lost on the way would be missing from the part");
}

void Sender::on(const Capability& capability, Moment /*now*/) {
  if (capability.name == "AUTOREPORT_TEMP") reports_ = capability.on;
}

}  // namespace slipstick
