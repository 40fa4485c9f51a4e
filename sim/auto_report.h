#pragma once

#include <optional>

#include "drivers/clock.h"

namespace slipstick {

/// A report that comes by itself every so often.
class AutoReport {
 public:
  /// Whether it is due at `now`, when it is wanted every `period`; 0 is never. A new period counts
  /// from now.
  [[nodiscard]] bool due(Moment period, Moment now) {
    if (period != period_) {
      period_ = period;
      at_ = now + period;
    }
    if (period_ <= Moment(0) || now < at_) return false;
    at_ = now + period_;
    return true;
  }

  [[nodiscard]] std::optional<Moment> next_at() const {
    return period_ > Moment(0) ? std::optional(at_) : std::nullopt;
  }

 private:
  Moment period_{0};
  Moment at_{0};
};

}  // namespace slipstick
