#include "drivers/marlin/session_probe.h"

#include <utility>
#include <variant>

namespace slipstick {
namespace {

/// Several round trips at 115200 baud; answers to older questions arrive too.
constexpr Moment kAnswerWait = std::chrono::milliseconds(200);
/// A board at a blocking command answers when that is over.
constexpr Moment kAskAgain = std::chrono::seconds(2);
constexpr std::string_view kWhere = "\nM114\n";

}  // namespace

void SessionProbe::receive(std::string_view bytes, Moment now) {
  if (!bytes.empty()) last_heard_ = now;
  splitter_.feed(bytes);
  while (const auto line = splitter_.next()) hear(parse_reply(*line));
  const bool answered = counted_ ? position_.has_value() : requested_ && last_line_;
  if (answered) next_ = std::min(next_, now + kAnswerWait);
}

void SessionProbe::hear(const Reply& reply) {
  if (std::holds_alternative<Start>(reply)) state_ = State::kReset;
  if (const auto* resend = std::get_if<Resend>(&reply)) requested_ = resend->line;
  if (const auto* error = std::get_if<LineError>(&reply)) last_line_ = error->last_line;
  if (const auto* report = std::get_if<PositionReport>(&reply)) position_ = report->position;
}

// What the answers to the last question tell, beside those to the one before.
void SessionProbe::conclude() {
  if (!counted_) {
    const bool whole = requested_ && last_line_ && *requested_ == *last_line_ + 1;
    counted_ = whole && last_ == last_line_;
    last_ = whole ? last_line_ : std::nullopt;
  } else if (position_) {
    if (place_ == position_) {
      found_ = {*last_, *place_};
      state_ = State::kFound;
    }
    place_ = position_;
  }
  requested_.reset();
  last_line_.reset();
  position_.reset();
}

std::string SessionProbe::take_output(Moment now) {
  if (!begun_) {
    begun_ = true;
    last_heard_ = now;
    next_ = now + kBannerWait;
  }
  if (state_ != State::kAsking || now < next_) return {};
  conclude();
  const bool hopeless = now - last_heard_ > kPatience || questions_ == kQuestionsMax;
  if (state_ == State::kAsking && hopeless) state_ = State::kSilent;
  if (state_ != State::kAsking) return {};
  ++questions_;
  next_ = now + kAskAgain;
  return counted_ ? std::string(kWhere) : "\n" + frame(beyond_, "M105");
}

}  // namespace slipstick
