#include "sim/kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace slipstick {

namespace {

constexpr int kPiecesMax = 65'535;

/// Of towers A and B in front, left and right, and C behind.
std::array<Vec2, 3> towers() {
  const double side = Kinematics::kRadius * std::numbers::sqrt3 / 2;
  const double front = -Kinematics::kRadius / 2;
  return {{{-side, front}, {side, front}, {0, Kinematics::kRadius}}};
}

/// How high a carriage is above the effector. Beyond the rod's reach: not at all.
double carriage_height(const Vec2& tower, const Axes& nozzle) {
  const double x = tower.x - nozzle.x;
  const double y = tower.y - nozzle.y;
  return std::sqrt(std::max(0.0, Kinematics::kRod * Kinematics::kRod - x * x - y * y));
}

}  // namespace

std::optional<Kinematics> Kinematics::named(std::string_view name) {
  if (name == "cartesian") return Kinematics(Kind::kCartesian);
  if (name == "corexy") return Kinematics(Kind::kCoreXy);
  if (name == "delta") return Kinematics(Kind::kDelta);
  return std::nullopt;
}

Axes Kinematics::motors(const Axes& nozzle) const {
  if (kind_ == Kind::kCoreXy) {
    return {nozzle.x + nozzle.y, nozzle.x - nozzle.y, nozzle.z, nozzle.e};
  }
  if (kind_ == Kind::kDelta) {
    const auto [a, b, c] = towers();
    return {nozzle.z + carriage_height(a, nozzle), nozzle.z + carriage_height(b, nozzle),
            nozzle.z + carriage_height(c, nozzle), nozzle.e};
  }
  return nozzle;
}

Axes Kinematics::corner_direction(const Axes& nozzle, const Axes& motors) const {
  return kind_ == Kind::kCoreXy ? (1 / length(motors)) * motors : nozzle;
}

int Kinematics::pieces(const Axes& from, const Axes& to, double speed) const {
  if (kind_ != Kind::kDelta || (from.x == to.x && from.y == to.y)) return 1;
  const double path = slipstick::length((to - from).xyz());
  return std::clamp(static_cast<int>(std::min<double>(kPiecesMax, kPiecesPerSecond * path / speed)),
                    1, kPiecesMax);
}

Axes Kinematics::within(Axes place, const Vec3& volume) const {
  place.z = std::clamp(place.z, 0.0, volume.z);
  if (kind_ != Kind::kDelta) {
    place.x = std::clamp(place.x, 0.0, volume.x);
    place.y = std::clamp(place.y, 0.0, volume.y);
    return place;
  }
  const double reach = std::min(volume.x, volume.y) / 2;
  const double away = std::sqrt(place.x * place.x + place.y * place.y);
  if (away > reach) {
    place.x *= reach / away;
    place.y *= reach / away;
  }
  return place;
}

Box3 Kinematics::reach(const Vec3& volume) const {
  if (kind_ != Kind::kDelta) return {{0, 0, 0}, volume};
  const double reach = std::min(volume.x, volume.y) / 2;
  return {{-reach, -reach, 0}, {reach, reach, volume.z}};
}

Vec3 Kinematics::home(const Vec3& volume) const {
  return {0, 0, kind_ == Kind::kDelta ? volume.z : 0};
}

std::string_view Kinematics::motor_names() const {
  switch (kind_) {
    case Kind::kCartesian:
      return "XYZ";
    case Kind::kCoreXy:
      return "ABZ";
    case Kind::kDelta:
      return "ABC";
  }
  return "XYZ";
}

}  // namespace slipstick
