#pragma once

#include <cstdint>
#include <vector>

#include "core/solid/ldni_sight.h"
#include "core/solid/solid.h"

namespace slipstick {

/// What is known of cubes of 8 by 8 by 8 widths of an LDNI, each as far as its rays are the
/// nearest: where no sample may have a say and the rays of two axes agree, all points have one
/// membership.
class LdniBlocks {
 public:
  static constexpr int kSide = 8;

  explicit LdniBlocks(const Ldni& ldni);

  /// Of all points p with low <= p <= high; certain unless mixed.
  [[nodiscard]] Cover cover(const LdniPoint& low, const LdniPoint& high) const;

 private:
  int resolution_;
  int side_;  // blocks
  std::vector<Cover> covers_;
};

}  // namespace slipstick
