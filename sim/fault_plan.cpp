#include "sim/fault_plan.h"

#include "core/base/check.h"

namespace slipstick {

FaultPlan::FaultPlan(double share, std::uint64_t seed) : share_(share), rng_(seed) {
  SLIPSTICK_CHECK(share >= 0 && share <= 1);
}

std::string FaultPlan::damaged(std::string_view bytes) {
  std::string arrived;
  arrived.reserve(bytes.size() + 1);
  for (const char byte : bytes) {
    if (rng_.unit() >= share_) {
      arrived += byte;
      continue;
    }
    ++count_;
    const std::uint64_t kind = rng_.below(3);
    if (kind == 0) arrived += static_cast<char>(byte ^ (1 << rng_.below(8)));
    if (kind == 1) arrived.append(2, byte);
  }
  return arrived;
}

}  // namespace slipstick
