#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

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
};

}  // namespace slipstick
