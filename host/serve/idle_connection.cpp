#include "host/serve/idle_connection.h"

#include "host/stream_job.h"

namespace slipstick {
namespace {

/// A job without lines, which is over when somebody says so.
class NoLinesUntil final : public LineSource {
 public:
  explicit NoLinesUntil(const std::function<bool()>& ended) : ended_(ended) {}

  Result<std::optional<Line>> next() override { return std::optional<Line>(); }
  bool ready() const override { return ended_(); }

 private:
  const std::function<bool()>& ended_;
};

}  // namespace

Result<void> stay_connected(Transport& transport, PrintControl& control,
                            const std::function<bool()>& ended) {
  const SteadyClock clock;
  NoLinesUntil nothing(ended);
  StreamOptions options{.pace = Pace::kRealTime};
  options.idle = true;
  // A printer that is mute would be greeted for a minute more.
  bool given_up = false;
  options.listeners.on_progress = [&](SenderState state, const SenderCounters&) {
    if (state != SenderState::kGreeting || !ended()) return;
    given_up = true;
    transport.shut_down();
  };
  const auto outcome = stream_job(transport, clock, nothing, options, control);
  if (!outcome && !given_up) return fail(outcome.error());
  return {};
}

}  // namespace slipstick
