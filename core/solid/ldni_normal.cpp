#include "core/solid/ldni_normal.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace slipstick {

std::optional<LdniNormal> LdniNormal::of(Vec3 direction) {
  const double largest =
      std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  const double sum = direction.x + direction.y + direction.z;  // NaN if one of them is
  if (!(largest > 0) || !std::isfinite(sum)) return {};
  const auto whole = [&](double v) {
    return static_cast<int>(std::lround(v / largest * kLargest));
  };
  return LdniNormal(whole(direction.x), whole(direction.y), whole(direction.z));
}

std::optional<LdniNormal> LdniNormal::from_word(std::uint32_t word) {
  LdniNormal normal;
  normal.word_ = word;
  const int largest =
      std::max({std::abs(normal.along(0)), std::abs(normal.along(1)), std::abs(normal.along(2))});
  if (word >> (3 * kBits) != 0 || largest != kLargest) return {};
  return normal;
}

}  // namespace slipstick
