#include "sim/trapezoid.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace slipstick {

namespace {

// What rounding may add to a difference of squared speeds.
constexpr double kRounding = 1 + 1e-9;
constexpr double kLeast2 = 1e-9;

}  // namespace

Trapezoid::Trapezoid(const Shape& shape) : shape_(shape) {
  SLIPSTICK_CHECK(shape.length > 0 && shape.cruise > 0 && shape.acceleration > 0);
  const double a = shape.acceleration;
  const double entry2 = shape.entry * shape.entry;
  const double exit2 = shape.exit * shape.exit;
  SLIPSTICK_CHECK(std::abs(exit2 - entry2) <= 2 * a * shape.length * kRounding + kLeast2);
  // Where both ramps meet: peak² - entry² + peak² - exit² = 2·a·length.
  const double meet2 = a * shape.length + (entry2 + exit2) / 2;
  peak_ = meet2 < shape.cruise * shape.cruise ? std::sqrt(meet2) : shape.cruise;
  peak_ = std::max({peak_, shape.entry, shape.exit});
  up_seconds_ = (peak_ - shape.entry) / a;
  down_seconds_ = (peak_ - shape.exit) / a;
  const double ramps = (2 * peak_ * peak_ - entry2 - exit2) / (2 * a);
  flat_seconds_ = std::max(0.0, shape.length - ramps) / peak_;
}

double Trapezoid::distance_at(double t) const {
  const double a = shape_.acceleration;
  if (t <= 0) return 0;
  if (t >= seconds()) return shape_.length;
  if (t < up_seconds_) return shape_.entry * t + a * t * t / 2;
  const double left = seconds() - t;
  if (left < down_seconds_) return shape_.length - (shape_.exit * left + a * left * left / 2);
  const double up = shape_.entry * up_seconds_ + a * up_seconds_ * up_seconds_ / 2;
  return up + peak_ * (t - up_seconds_);
}

}  // namespace slipstick
