#include "core/base/angle.h"

#include <cmath>
#include <numbers>

#include "core/base/elementary.h"

namespace slipstick {

Vec2 direction_of(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  if (turned == 0) return {1, 0};
  if (turned == 90) return {0, 1};
  if (turned == -90) return {0, -1};
  if (std::abs(turned) == 180) return {-1, 0};
  const double radians = turned * std::numbers::pi / 180;
  return {cosine(radians), sine(radians)};
}

}  // namespace slipstick
