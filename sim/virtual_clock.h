#pragma once

#include <atomic>

#include "drivers/clock.h"

namespace slipstick {

/// Time that stands still until its owner moves it.
class VirtualClock final : public Clock {
 public:
  [[nodiscard]] Moment now() const override { return Moment(now_.load()); }

  /// Moves on to `to`; an earlier moment changes nothing. One thread.
  void advance_to(Moment to) {
    if (to > now()) now_.store(to.count());
  }

 private:
  std::atomic<Moment::rep> now_{0};
};

}  // namespace slipstick
