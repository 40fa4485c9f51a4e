#include "core/base/affine.h"

#include "core/base/angle.h"
#include "core/base/check.h"

namespace slipstick {

Affine3 composed(const Affine3& outer, const Affine3& inner) {
  Affine3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      double sum = j == 3 ? outer.rows[i][3] : 0;
      for (std::size_t k = 0; k < 3; ++k) sum += outer.rows[i][k] * inner.rows[k][j];
      result.rows[i][j] = sum;
    }
  }
  return result;
}

Affine3 inverse(const Affine3& map) {
  const auto column = [&](std::size_t j) {
    return Vec3{map.rows[0][j], map.rows[1][j], map.rows[2][j]};
  };
  const Vec3 a = column(0), b = column(1), c = column(2), t = column(3);
  const double determinant = dot(a, cross(b, c));
  SLIPSTICK_CHECK(determinant != 0);
  const std::array<Vec3, 3> dual{cross(b, c), cross(c, a), cross(a, b)};
  Affine3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 row = (1 / determinant) * dual[i];
    result.rows[i] = {row.x, row.y, row.z, -dot(row, t)};
  }
  return result;
}

Box3 image_of(const Affine3& map, const Box3& box) {
  Box3 result;
  for (int corner = 0; corner < 8; ++corner) {
    result = result.with(
        map({(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
             (corner & 4) != 0 ? box.high.z : box.low.z}));
  }
  return result;
}

Affine3 rotation_degrees(Vec3 angles) {
  const auto [cx, sx] = direction_of(angles.x);
  const auto [cy, sy] = direction_of(angles.y);
  const auto [cz, sz] = direction_of(angles.z);
  const Affine3 about_x{{{{1, 0, 0, 0}, {0, cx, -sx, 0}, {0, sx, cx, 0}}}};
  const Affine3 about_y{{{{cy, 0, sy, 0}, {0, 1, 0, 0}, {-sy, 0, cy, 0}}}};
  const Affine3 about_z{{{{cz, -sz, 0, 0}, {sz, cz, 0, 0}, {0, 0, 1, 0}}}};
  return composed(about_z, composed(about_y, about_x));
}

Affine3 rotation_to_z(Vec3 direction) {
  const double norm = length(direction);
  SLIPSTICK_CHECK(norm > 0);
  const Vec3 d = (1 / norm) * direction;
  // Rodrigues' formula about d × z; straight down has no shortest way, so turn about x.
  if (d.z < -1 + 1e-12) return rotation_degrees({180, 0, 0});
  const double k = 1 / (1 + d.z);
  return {{{{1 - d.x * d.x * k, -d.x * d.y * k, -d.x, 0},
            {-d.x * d.y * k, 1 - d.y * d.y * k, -d.y, 0},
            {d.x, d.y, d.z, 0}}}};
}

}  // namespace slipstick
