#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "drivers/clock.h"
#include "sim/fault_plan.h"

namespace slipstick {

/// One direction of the wire: bytes go in at a moment and come out when they have been transmitted.
///
/// A byte takes ten bits (8N1). A baud rate of 0 is native USB: everything arrives at once. With a
/// tick, as the latency timers of USB adapters have it, what has arrived is there at the next
/// multiple of it.
class BytePipe {
 public:
  static constexpr int kBitsPerByte = 10;

  /// \pre `tick` >= 0.
  BytePipe(int baud, FaultPlan faults, Moment tick = Moment(0))
      : baud_(baud), faults_(std::move(faults)), tick_(tick) {}

  /// Sends `bytes` behind all that is still under way. \pre `at` never goes back.
  void push(std::string_view bytes, Moment at);

  /// When the first byte not yet taken is, or was, there.
  [[nodiscard]] std::optional<Moment> next_at() const;

  /// When the last byte sent so far is through.
  [[nodiscard]] Moment idle_at() const;

  /// How many bytes were sent and not yet taken.
  [[nodiscard]] std::size_t pending() const { return bytes_.size() - head_; }

  /// Moves bytes that have arrived by `by` into `buffer`. \return How many.
  std::size_t take(std::span<char> buffer, Moment by);

  /// Forgets all that was not taken.
  void clear();

  /// Whether it paces bytes like a UART (and does not wait for a slow receiver).
  [[nodiscard]] bool paced() const { return baud_ > 0; }
  [[nodiscard]] const FaultPlan& faults() const { return faults_; }

 private:
  /// Bytes sent back to back from `start` on.
  struct Burst {
    std::int64_t start_ns;
    std::int64_t taken;
    std::int64_t count;
  };

  [[nodiscard]] std::int64_t duration_ns(std::int64_t bytes) const;
  [[nodiscard]] std::int64_t arrived(const Burst& burst, Moment by) const;

  int baud_;
  FaultPlan faults_;
  Moment tick_;
  std::string bytes_;  ///< From `head_` on: not yet taken.
  std::size_t head_ = 0;
  std::deque<Burst> bursts_;
  std::int64_t idle_ns_ = 0;
};

}  // namespace slipstick
