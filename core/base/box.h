#pragma once

#include <algorithm>
#include <limits>

#include "core/base/vec.h"

namespace slipstick {

/// A closed rectangle. A default one is empty and grows by `with`.
struct Box2 {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  [[nodiscard]] constexpr bool empty() const { return !(low.x <= high.x && low.y <= high.y); }
  [[nodiscard]] constexpr Box2 with(Vec2 p) const {
    return {{std::min(low.x, p.x), std::min(low.y, p.y)},
            {std::max(high.x, p.x), std::max(high.y, p.y)}};
  }

  friend constexpr bool operator==(const Box2&, const Box2&) = default;
};

/// A closed box. A default one is empty and grows by `with`.
struct Box3 {
  Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity()};

  [[nodiscard]] constexpr bool empty() const {
    return !(low.x <= high.x && low.y <= high.y && low.z <= high.z);
  }
  [[nodiscard]] constexpr Vec3 size() const { return high - low; }
  [[nodiscard]] constexpr Vec3 centre() const { return 0.5 * (low + high); }
  [[nodiscard]] constexpr Box3 with(Vec3 p) const {
    return {{std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)},
            {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)}};
  }
  /// The part in both.
  [[nodiscard]] constexpr Box3 within(const Box3& b) const {
    return {{std::max(low.x, b.low.x), std::max(low.y, b.low.y), std::max(low.z, b.low.z)},
            {std::min(high.x, b.high.x), std::min(high.y, b.high.y), std::min(high.z, b.high.z)}};
  }

  friend constexpr bool operator==(const Box3&, const Box3&) = default;
};

}  // namespace slipstick
