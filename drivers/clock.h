#pragma once

#include <chrono>

namespace slipstick {

/// Time since some fixed moment, to the microsecond. Everything that waits or measures gets it from
/// a `Clock`.
using Moment = std::chrono::microseconds;

/// Where time comes from: the machine, a simulated printer or a test.
class Clock {
 public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  virtual ~Clock() = default;

  /// Never goes back. Any thread.
  [[nodiscard]] virtual Moment now() const = 0;
};

/// The machine's monotonic clock.
class SteadyClock final : public Clock {
 public:
  [[nodiscard]] Moment now() const override {
    return std::chrono::duration_cast<Moment>(std::chrono::steady_clock::now().time_since_epoch());
  }
};

}  // namespace slipstick
