#include "host/stream_job.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "host/interrupt.h"
#include "host/last_words.h"
#include "host/output_queue.h"
#include "host/pause.h"
#include "host/printer_words.h"

namespace slipstick {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds kWaitMax{20};          // how late a request may be noticed,
constexpr milliseconds kVirtualWaitMax{250};  // and in virtual time
constexpr milliseconds kFullWait{2};          // how often to try a port that takes nothing
constexpr milliseconds kHungryWait{5};        // how often to look for a line that is being made
constexpr milliseconds kPausedNap{20};  // in virtual time, which would fly while nothing is sent
constexpr seconds kStopPatience{30};    // for the safe end after a failure
constexpr milliseconds kDtrPulse{100};
constexpr milliseconds kHearOut{300};  // after the printer's last words
constexpr const char* kMaybeHot = "; the printer's heaters may still be on";

class Stream {
 public:
  Stream(Transport& transport, const Clock& clock, LineSource& source, const StreamOptions& options,
         PrintControl& control)
      : transport_(transport),
        clock_(clock),
        source_(source),
        pace_(options.pace),
        idle_(options.idle),
        control_(control),
        listeners_(options.listeners),
        output_(transport, clock),
        pause_(options.parking, options.state, options.first),
        began_(clock.now()),
        sender_(options.sender) {
    control_.heed(true);
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() {
    control_.heed(false);
    control_.stop_listening();
  }

  Result<StreamOutcome> run() {
    while (true) {
      heed_requests();
      if (const auto ok = feed_and_write(); !ok) return out_of_reach(ok.error());
      const SenderState state = sender_.state();
      if (state == SenderState::kReady || state == SenderState::kPrinting) greeted();
      outcome_.counters = sender_.counters();
      control_.tell(state, outcome_);
      if (listeners_.on_progress) listeners_.on_progress(state, outcome_);
      if (state == SenderState::kDone) break;
      if (state == SenderState::kHalted || state == SenderState::kLost) return given_up();
      if (stop_deadline_ && clock_.now() > *stop_deadline_) sender_.abandon("it does not stop");
      if (const auto ok = read(); !ok) return out_of_reach(ok.error());
    }
    if (failure_) return failed("heaters are off");
    outcome_.not_done = words_.not_done();
    outcome_.unknown_commands = words_.unknown();
    outcome_.seconds = std::chrono::duration<double>(clock_.now() - began_).count();
    return outcome_;
  }

 private:
  void greeted() {
    if (!std::exchange(greeted_, true) && !ended_) control_.begin_listening();
  }

  void heed_requests() {
    const PrintControl::Wish wish = wished();
    if (wish == PrintControl::Wish::kEmergencyStop || Interrupt::urgent()) {
      kill();
    } else if (wish == PrintControl::Wish::kCancel) {
      give_up({ErrorCode::kCancelled, "cancelled"});
    }
    if (Interrupt::requested()) give_up({ErrorCode::kCancelled, "interrupted"});
    const auto manner = printer_holds_ ? Pause::Manner::kStay : Pause::Manner::kPark;
    if (!ended_ && pause_.heed(wish, manner)) {
      spdlog::warn("{}", pause_.wanted() ? "pausing" : "going on");
    }
  }

  [[nodiscard]] PrintControl::Wish wished() {
    // Whoever presses Ctrl-Z in a pause that others have asked for wants it to end.
    const bool pressed = std::exchange(held_by_terminal_, Interrupt::pause()) != Interrupt::pause();
    if (pressed && control_.resume()) Interrupt::forget_pause();
    held_by_terminal_ = Interrupt::pause();
    const PrintControl::Wish wish = control_.wish();
    if (wish == PrintControl::Wish::kRun && held_by_terminal_) return PrintControl::Wish::kPause;
    if (wish != PrintControl::Wish::kPause) printer_holds_ = false;
    return wish;
  }

  // Before everything that waits: what has not left this machine is forgotten.
  void kill() {
    if (killed_) return;
    killed_ = true;
    failure_.reset();
    give_up({ErrorCode::kCancelled, "emergency stop; reset the printer"});
    sender_.emergency_stop();
    output_.clear();
  }

  // A window takes several lines in a row; each turn fills it by one, so that this ends.
  Result<void> feed_and_write() {
    while (true) {
      const std::uint64_t sent = sender_.counters().lines_sent;
      feed();
      if (const auto ok = write(); !ok) return ok;
      const bool took = sender_.counters().lines_sent > sent;
      if (!took || ended_ || hungry_ || !sender_.wants_line()) return {};
    }
  }

  void feed() {
    hungry_ = false;
    while (!ended_ && sender_.wants_line()) {
      if (const auto line = unasked()) {
        sender_.push(*line, LineOwner::kHost);
        continue;
      }
      if (!pause_.holds() && source_.take_pause() && control_.pause()) {
        heed_requests();
        continue;
      }
      if (pause_.holds()) {
        if (pace_ == Pace::kVirtual) std::this_thread::sleep_for(kPausedNap);
        return;
      }
      if (pace_ == Pace::kRealTime && !source_.ready()) {
        hungry_ = true;
        return;
      }
      feed_job();
    }
  }

  // A line that is none of the job's.
  std::optional<Line> unasked() {
    if (const auto line = pause_.next()) return line;
    if (printer_holds_) return std::nullopt;
    auto line = control_.take_interjection();
    if (line) pause_.follow(*line);
    return line;
  }

  void feed_job() {
    auto line = source_.next();
    if (!line) return give_up(line.error());
    if (*line) {
      pause_.follow(**line);
      sender_.push(std::move(**line));
    } else if (control_.end_listening()) {
      ended_ = true;
      sender_.end_of_job();
    }
  }

  void give_up(const Error& error) {
    if (failure_) return;
    failure_ = error;
    ended_ = true;
    control_.stop_listening();
    stop_deadline_ = clock_.now() + kStopPatience;
    sender_.stop();
  }

  // Nothing of the job goes out any more, but what makes the printer safe does.
  Result<StreamOutcome> given_up() {
    while (sender_.wakeup()) {
      heed_requests();
      if (!write() || !read()) break;
    }
    if (killed_) hear_out();
    if (killed_ && !sender_.printer_stopped()) {
      reset_board();
      failure_->message = "the printer did not confirm the emergency stop: switch it off";
    }
    if (killed_) return fail(*failure_);
    return failed(sender_.printer_stopped() ? sender_.reason() : sender_.reason() + kMaybeHot);
  }

  // A board that says it was stopped and goes on is not stopped.
  void hear_out() {
    const Moment until = clock_.now() + kHearOut;
    while (clock_.now() < until && sender_.printer_stopped()) {
      if (!read()) return;
    }
  }

  // Why the print ends early, and how that left the printer: never said before it is known.
  tl::unexpected<Error> failed(const std::string& how) const {
    if (!failure_) return fail(ErrorCode::kPrinter, how);
    return fail(failure_->code, failure_->message + "; " + how);
  }

  // The last resort: whatever the firmware is at, a reset switches the heaters off.
  void reset_board() {
    if (!transport_.set_dtr(false)) return;
    spdlog::warn("{}: resetting the board by DTR", transport_.name());
    const auto ignored = transport_.read_some(buffer_, kDtrPulse);
    static_cast<void>(ignored);
    transport_.set_dtr(true);
  }

  Result<StreamOutcome> out_of_reach(const Error& error) {
    if (error.code == ErrorCode::kTimedOut) reset_board();
    if (failure_) return failed(error.message + kMaybeHot);
    const bool gone = error.code == ErrorCode::kUnavailable;
    return fail(gone ? ErrorCode::kDisconnected : error.code, error.message + kMaybeHot);
  }

  void heed(const PrinterWords::Heard& heard) {
    using enum PrinterWords::Wish;
    if (ended_ || heard.wish == kNone || (idle_ && heard.wish != kEnd)) return;
    const bool alone = heard.wish == kWait && pace_ == Pace::kVirtual;
    if (heard.wish == kEnd || alone) return give_up({ErrorCode::kPrinter, heard.reason});
    if (heard.wish == kCancel) return give_up({ErrorCode::kCancelled, "cancelled at the printer"});
    if (heard.wish == kGoOn) {
      if (control_.resume()) Interrupt::forget_pause();
      return;
    }
    if (!control_.pause()) return;
    printer_holds_ = heard.wish == kHold;
    if (heard.wish == kWait) spdlog::warn("{}; pausing", heard.reason);
  }

  Result<void> write() {
    output_.push(sender_.take_output(clock_.now()));
    // A journal says what numbers mean before the printer can have them.
    take_events();
    const bool anything = !output_.empty();
    auto written = output_.write();
    if (anything) outcome_.turnaround.answered(clock_.now());
    return written;
  }

  Result<void> read() {
    outcome_.turnaround.forget();
    const Moment before = clock_.now();
    const auto got = transport_.read_some(buffer_, patience(before));
    const Moment after = clock_.now();
    if (hungry_) outcome_.starved_seconds += std::chrono::duration<double>(after - before).count();
    if (got) {
      outcome_.turnaround.heard(after);
      sender_.receive({buffer_.data(), *got}, after);
    } else if (got.error().code != ErrorCode::kTimedOut) {
      return fail(got.error());
    }
    return {};
  }

  microseconds patience(Moment now) const {
    microseconds wait = pace_ == Pace::kVirtual ? kVirtualWaitMax : kWaitMax;
    if (hungry_) wait = kHungryWait;
    if (!output_.empty()) wait = kFullWait;
    if (const auto wakeup = sender_.wakeup()) wait = std::min(wait, *wakeup - now);
    return std::max(wait, microseconds(1));
  }

  void take_events() {
    for (const SenderEvent& event : sender_.take_events()) {
      control_.tell(event);
      if (listeners_.on_event) listeners_.on_event(event);
      heed(words_.hear(event));
      if (const auto* firmware = std::get_if<FirmwareSeen>(&event)) {
        outcome_.firmware = firmware->name;
      } else if (const auto* message = std::get_if<MessageSeen>(&event)) {
        tell_user(message->text);
      } else if (std::holds_alternative<ResetWanted>(event)) {
        reset_board();
      } else if (const auto* resend = std::get_if<ResendSeen>(&event)) {
        spdlog::debug("printer asks for line {} again", resend->line);
      }
    }
  }

  // A complaint about every move is one message.
  void tell_user(const std::string& message) {
    const bool again = message == last_message_;
    spdlog::log(again ? spdlog::level::debug : spdlog::level::info, "printer: {}", message);
    last_message_ = message;
  }

  Transport& transport_;
  const Clock& clock_;
  LineSource& source_;
  const Pace pace_;
  const bool idle_;
  PrintControl& control_;
  const PrintControl::Listeners listeners_;
  OutputQueue output_;
  Pause pause_;
  const Moment began_;
  Sender sender_;
  StreamOutcome outcome_;
  std::optional<Error> failure_;
  std::optional<Moment> stop_deadline_;
  PrinterWords words_;
  std::string last_message_;
  bool printer_holds_ = false;  ///< It has parked by itself and is to be left alone.
  bool held_by_terminal_ = false;
  bool greeted_ = false;
  bool ended_ = false;
  bool killed_ = false;
  bool hungry_ = false;
  std::array<char, 4096> buffer_;
};

}  // namespace

Result<StreamOutcome> stream_job(Transport& transport, const Clock& clock, LineSource& source,
                                 const StreamOptions& options) {
  PrintControl nobody;
  return stream_job(transport, clock, source, options, nobody);
}

Result<StreamOutcome> stream_job(Transport& transport, const Clock& clock, LineSource& source,
                                 const StreamOptions& options, PrintControl& control) {
  const LastWords last_words(transport.descriptor(), options.journal);
  return Stream(transport, clock, source, options, control).run();
}

}  // namespace slipstick
