#pragma once

#include <string>

#include "drivers/clock.h"
#include "drivers/transport.h"

namespace slipstick {

/// Bytes on their way into a port that may not take them: writing never waits, so that an emergency
/// stop is never held up. Holds what one turn of the sender gives, since it gives no more before
/// that is answered.
class OutputQueue {
 public:
  /// A port that takes nothing for this long is stuck.
  static constexpr Moment kStallMax = std::chrono::seconds(10);

  OutputQueue(Transport& transport, const Clock& clock) : transport_(transport), clock_(clock) {}

  void push(std::string_view bytes) { pending_ += bytes; }

  /// Hands over what the port takes now. Fails as `Transport::write_some`; kTimedOut only after
  /// `kStallMax`.
  [[nodiscard]] Result<void> write();

  [[nodiscard]] bool empty() const { return pending_.empty(); }

  /// Forgets everything that has not left this machine.
  void clear();

 private:
  Transport& transport_;
  const Clock& clock_;
  std::string pending_;
  Moment progress_at_{};  ///< When the port last took something, or had nothing to take.
};

}  // namespace slipstick
