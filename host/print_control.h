#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "drivers/marlin/line.h"
#include "drivers/marlin/sender_events.h"

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
    std::function<void(SenderState, const SenderCounters&)> on_progress;  ///< Once a turn.
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
  /// `lines` go out before the next line of the job. \return false, and none does, if too many
  /// wait. \pre each is an `interjection`.
  bool interject(const std::vector<Line>& lines) {
    const std::lock_guard lock(mutex_);
    if (interjections_.size() + lines.size() > kInterjectionsMax) return false;
    interjections_.insert(interjections_.end(), lines.begin(), lines.end());
    return true;
  }
  /// Takes the first that waits.
  [[nodiscard]] std::optional<Line> take_interjection() {
    const std::lock_guard lock(mutex_);
    if (interjections_.empty()) return std::nullopt;
    std::optional<Line> line = std::move(interjections_.front());
    interjections_.pop_front();
    return line;
  }

  [[nodiscard]] Wish wish() const { return wish_.load(); }

  void tell(const SenderEvent& event) const {
    if (listeners_.on_event) listeners_.on_event(event);
  }
  void tell(SenderState state, const SenderCounters& counters) const {
    if (listeners_.on_progress) listeners_.on_progress(state, counters);
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
  std::mutex mutex_;  ///< Protects what follows.
  std::deque<Line> interjections_;
};

}  // namespace slipstick
