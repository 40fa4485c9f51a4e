#pragma once

#include <string>

#include "drivers/clock.h"

namespace slipstick {

/// Marlin's print job timer: M75 to M77, M31, and the heaters start and stop it.
class JobTimer {
 public:
  void start(Moment now) {
    if (running_) return;
    running_ = true;
    since_ = now;
  }
  void pause(Moment now) {
    passed_ = passed(now);
    running_ = false;
  }
  /// The next start begins anew.
  void stop(Moment now) {
    if (!running_ && passed_ == Moment(0)) return;
    last_ = passed(now);
    running_ = false;
    passed_ = Moment(0);
  }

  [[nodiscard]] bool running() const { return running_; }
  /// "1h 2m 3s": of this job, or the last one.
  [[nodiscard]] std::string text(Moment now) const;

 private:
  [[nodiscard]] Moment passed(Moment now) const {
    return passed_ + (running_ ? now - since_ : Moment(0));
  }

  bool running_ = false;
  Moment since_{0};
  Moment passed_{0};
  Moment last_{0};
};

}  // namespace slipstick
