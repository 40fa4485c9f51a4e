#include "host/serve/idle_connection.h"

#include "host/stream_job.h"

namespace slipstick {
namespace {

/// A job that is over when somebody says so. Until then it asks for temperatures now and then, also
/// of a printer that tells them by itself: or nobody would notice that it is not there any more.
class SmallTalk final : public LineSource {
 public:
  SmallTalk(const Clock& clock, const std::function<bool()>& ended)
      : clock_(clock), ended_(ended), due_(clock.now() + kBetweenQuestions) {}

  Result<std::optional<Line>> next() override {
    if (ended_()) return std::optional<Line>();
    due_ = clock_.now() + kBetweenQuestions;
    return std::optional(*Line::make("M105"));
  }
  bool ready() const override { return ended_() || clock_.now() >= due_; }

 private:
  static constexpr Moment kBetweenQuestions = std::chrono::seconds(30);

  const Clock& clock_;
  const std::function<bool()>& ended_;
  Moment due_;
};

}  // namespace

Result<void> stay_connected(Transport& transport, const Clock& clock, PrintControl& control,
                            const std::function<bool()>& ended) {
  SmallTalk talk(clock, ended);
  StreamOptions options{.pace = Pace::kRealTime};
  options.idle = true;
  // A printer that is mute would be greeted for a minute more.
  bool given_up = false;
  options.listeners.on_progress = [&](SenderState state, const StreamFigures&) {
    if (state != SenderState::kGreeting || !ended()) return;
    given_up = true;
    transport.shut_down();
  };
  const auto outcome = stream_job(transport, clock, talk, options, control);
  if (!outcome && !given_up) return fail(outcome.error());
  return {};
}

}  // namespace slipstick
