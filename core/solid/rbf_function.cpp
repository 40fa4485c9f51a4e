#include "core/solid/rbf_function.h"

#include <algorithm>

namespace slipstick {
namespace {

// A polynomial of ten terms rounds by less than 32 units in the last place of the sum of their
// sizes; this is thousands of times that, and still nothing beside a cell.
constexpr double kRounding = 1e-12;

double square(double a) {
  return a * a;
}

}  // namespace

// Taylor about the middle: exact, since nothing is beyond the second order.
RbfRange quadric_range(const RbfFunction::Quadric& q, Vec3 middle, Vec3 half) {
  const double value = quadric_at(q, middle);
  const double gx = q[1] + 2 * q[4] * middle.x + q[7] * middle.y + q[9] * middle.z;
  const double gy = q[2] + 2 * q[5] * middle.y + q[7] * middle.x + q[8] * middle.z;
  const double gz = q[3] + 2 * q[6] * middle.z + q[8] * middle.y + q[9] * middle.x;
  const auto between = [](double a, double low, double high) {
    return RbfRange{a * (a < 0 ? high : low), a * (a < 0 ? low : high)};
  };
  const RbfRange xx = between(q[4], 0, square(half.x));
  const RbfRange yy = between(q[5], 0, square(half.y));
  const RbfRange zz = between(q[6], 0, square(half.z));
  const double swing = std::abs(gx) * half.x + std::abs(gy) * half.y + std::abs(gz) * half.z +
                       std::abs(q[7]) * half.x * half.y + std::abs(q[8]) * half.y * half.z +
                       std::abs(q[9]) * half.z * half.x;
  const Vec3 far{std::abs(middle.x) + half.x, std::abs(middle.y) + half.y,
                 std::abs(middle.z) + half.z};
  RbfFunction::Quadric sizes = q;
  for (double& c : sizes) c = std::abs(c);
  const double rounding = kRounding * quadric_at(sizes, far);
  return {value + xx.low + yy.low + zz.low - swing - rounding,
          value + xx.high + yy.high + zz.high + swing + rounding};
}

double nearest_square(const Box3& box, Vec3 p) {
  const auto gap = [](double low, double high, double at) {
    return std::max({low - at, at - high, 0.0});
  };
  return square(gap(box.low.x, box.high.x, p.x)) + square(gap(box.low.y, box.high.y, p.y)) +
         square(gap(box.low.z, box.high.z, p.z));
}

double farthest_square(const Box3& box, Vec3 p) {
  const auto reach = [](double low, double high, double at) {
    return std::max(std::abs(at - low), std::abs(high - at));
  };
  return square(reach(box.low.x, box.high.x, p.x)) + square(reach(box.low.y, box.high.y, p.y)) +
         square(reach(box.low.z, box.high.z, p.z));
}

}  // namespace slipstick
