#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "drivers/marlin/line.h"
#include "drivers/marlin/sender_events.h"
#include "host/stream_figures.h"

namespace slipstick {

/// What others may ask of a print under way, and how they hear of it.
///
/// Threads: requests may be made by any thread at any time, also before the print begins; the
/// listeners are called by the printing thread and must not wait.
class PrintControl {
 public:
  /// In order of urgency: a request never takes a more urgent one back.
  enum class Wish : std::uint8_t { kRun, kPause, kCancel, kEmergencyStop };

  struct Listeners {
    std::function<void(const SenderEvent&)> on_event;
    std::function<void(SenderState, const StreamFigures&)> on_progress;  ///< Once a turn.
  };

  PrintControl() = default;
  explicit PrintControl(Listeners listeners) : listeners_(std::move(listeners)) {}
  PrintControl(const PrintControl&) = delete;
  PrintControl& operator=(const PrintControl&) = delete;

  /// No further line is sent until `resume`; those the printer has are finished, and the nozzle is
  /// parked.
  /// \return whether that changed anything.
  bool pause() { return change(Wish::kRun, Wish::kPause); }
  bool resume() { return change(Wish::kPause, Wish::kRun); }
  /// Ends the print with heaters, fan and motors off.
  void cancel() { raise(Wish::kCancel); }
  /// Kills the printer at once; only a reset wakes it.
  void emergency_stop() { raise(Wish::kEmergencyStop); }

  /// Lines that may wait to be said.
  static constexpr std::size_t kInterjectionsMax = 32;
  /// `lines` go out before the next line of the job. \return kPrinter, and none does, if too many
  /// wait, or if nobody would send them: before the printer is greeted, and behind the last line.
  /// \pre each is an `interjection`, where there is a job.
  [[nodiscard]] Result<void> interject(const std::vector<Line>& lines) {
    const std::lock_guard lock(mutex_);
    if (!listens_) return fail(ErrorCode::kPrinter, "no printer is connected");
    if (interjections_.size() + lines.size() > kInterjectionsMax)
      return fail(ErrorCode::kPrinter, "too many commands wait for the printer; try again later");
    interjections_.insert(interjections_.end(), lines.begin(), lines.end());
    return {};
  }
  /// Takes the first that waits.
  [[nodiscard]] std::optional<Line> take_interjection() {
    const std::lock_guard lock(mutex_);
    if (interjections_.empty()) return std::nullopt;
    std::optional<Line> line = std::move(interjections_.front());
    interjections_.pop_front();
    return line;
  }
  /// Whoever prints sends interjections from now on.
  void begin_listening() {
    const std::lock_guard lock(mutex_);
    listens_ = true;
  }
  /// No more are sent. \return false, and nothing changes, if some wait.
  [[nodiscard]] bool end_listening() {
    const std::lock_guard lock(mutex_);
    if (!interjections_.empty()) return false;
    listens_ = false;
    return true;
  }
  /// No more are sent, and what waits is dropped.
  void stop_listening() {
    const std::lock_guard lock(mutex_);
    listens_ = false;
    interjections_.clear();
  }

  /// Whether somebody heeds wishes at once: not before the printer's port is open, nor while a
  /// print waits for it to come back.
  [[nodiscard]] bool is_heeded() const { return heeded_.load(); }
  void heed(bool from_now_on) { heeded_ = from_now_on; }

  [[nodiscard]] Wish wish() const { return wish_.load(); }

  void tell(const SenderEvent& event) const {
    if (listeners_.on_event) listeners_.on_event(event);
  }
  void tell(SenderState state, const StreamFigures& figures) const {
    if (listeners_.on_progress) listeners_.on_progress(state, figures);
  }

 private:
  bool change(Wish from, Wish to) { return wish_.compare_exchange_strong(from, to); }
  void raise(Wish to) {
    Wish now = wish_.load();
    while (now < to && !wish_.compare_exchange_weak(now, to)) {
    }
  }

  const Listeners listeners_{};
  std::atomic<Wish> wish_{Wish::kRun};
  std::atomic<bool> heeded_{false};
  std::mutex mutex_;  ///< Protects what follows.
  std::deque<Line> interjections_;
  bool listens_ = false;
};

}  // namespace slipstick
