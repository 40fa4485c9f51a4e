#pragma once

#include <array>

#include "core/base/box.h"
#include "core/base/vec.h"

namespace slipstick {

/// An affine map of space: `rows[i] · (x, y, z, 1)`.
struct Affine3 {
  std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  [[nodiscard]] constexpr Vec3 operator()(Vec3 p) const {
    const auto row = [&](int i) {
      const auto& r = rows[static_cast<std::size_t>(i)];
      return r[0] * p.x + r[1] * p.y + r[2] * p.z + r[3];
    };
    return {row(0), row(1), row(2)};
  }

  friend constexpr bool operator==(const Affine3&, const Affine3&) = default;
};

/// First `inner`, then `outer`.
[[nodiscard]] Affine3 composed(const Affine3& outer, const Affine3& inner);

/// The map back. \pre `map` is invertible.
[[nodiscard]] Affine3 inverse(const Affine3& map);

/// The smallest box around the image of `box`.
[[nodiscard]] Box3 image_of(const Affine3& map, const Box3& box);

[[nodiscard]] constexpr Affine3 translation(Vec3 by) {
  return {{{{1, 0, 0, by.x}, {0, 1, 0, by.y}, {0, 0, 1, by.z}}}};
}
[[nodiscard]] constexpr Affine3 scaling(Vec3 by) {
  return {{{{by.x, 0, 0, 0}, {0, by.y, 0, 0}, {0, 0, by.z, 0}}}};
}

/// Turns about x, then y, then z, by the right-hand rule. Multiples of 90° are exact.
[[nodiscard]] Affine3 rotation_degrees(Vec3 angles);

/// The rotation that takes `direction` to +z by the shortest way. \pre `direction` is not zero.
[[nodiscard]] Affine3 rotation_to_z(Vec3 direction);

}  // namespace slipstick
