#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "drivers/clock.h"

namespace slipstick {

/// How long the printer waits for us: from bytes that were read to the bytes they gave rise to.
/// What has to wait for a line that is still being made is not counted; that is starvation.
///
/// Memory is constant: times are kept in steps of 1/16 of themselves.
class Turnaround {
 public:
  /// Something came at `now`.
  void heard(Moment now) { heard_ = now; }
  /// Something goes out at `now`; counted, if it follows what was heard in this turn.
  void answered(Moment now);
  /// The turn is over.
  void forget() { heard_.reset(); }

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// The time within which a share of them, 0 to 1, were answered: at most 1/16 too much; 0 if
  /// there are none. What took longer than a minute counts as a minute.
  [[nodiscard]] Moment within(double share) const;
  /// Likewise in seconds.
  [[nodiscard]] double seconds_within(double share) const {
    return std::chrono::duration<double>(within(share)).count();
  }

 private:
  static constexpr unsigned kSteps = 16;  // from one power of two to the next
  static constexpr Moment kLongest = std::chrono::minutes(1);
  static constexpr std::size_t kBuckets = std::size_t{24} * kSteps;

  [[nodiscard]] static std::size_t bucket_of(std::uint64_t microseconds);
  [[nodiscard]] static Moment end_of(std::size_t bucket);

  std::optional<Moment> heard_;
  std::uint64_t count_ = 0;
  std::array<std::uint32_t, kBuckets> counts_{};
};

}  // namespace slipstick
