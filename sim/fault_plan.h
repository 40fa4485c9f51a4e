#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/rng.h"

namespace slipstick {

/// What goes wrong on one direction of the wire: the only place where faults are made.
class FaultPlan {
 public:
  /// A wire that damages `share` of its bytes, each time in one of three ways by chance: one bit
  /// flips, the byte is lost, the byte comes twice. \pre 0 <= `share` <= 1.
  FaultPlan(double share, std::uint64_t seed);

  [[nodiscard]] bool harmless() const { return share_ <= 0; }

  /// `bytes` as they arrive.
  [[nodiscard]] std::string damaged(std::string_view bytes);

  /// How many bytes were damaged so far.
  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  double share_;
  Rng rng_;
  std::int64_t count_ = 0;
};

}  // namespace slipstick
