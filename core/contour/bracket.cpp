#include "core/contour/bracket.h"

#include <algorithm>

namespace slipstick {

std::int32_t Bracket::choose() const {
  const std::int32_t middle = inside_ + (outside_ - inside_) / 2;
  if (looks_ >= kQuickLooks) return middle;
  double at = looks_ > 0 ? quadratic() : chord();
  if (!holds(at)) at = chord();
  if (!holds(at)) return middle;
  return std::clamp(static_cast<std::int32_t>(at), inside_ + 1, outside_ - 1);
}

void Bracket::take(double value) {
  ++looks_;
  std::int32_t& end = value <= 0 ? inside_ : outside_;
  double& f_end = value <= 0 ? f_inside_ : f_outside_;
  before_ = end;
  f_before_ = f_end;
  end = next_;
  f_end = value;
  if (!closed()) next_ = choose();
}

// Where the line through both ends is zero.
double Bracket::chord() const {
  return inside_ + (outside_ - inside_) * (f_inside_ / (f_inside_ - f_outside_));
}

// Where the quadratic in f through three places is zero; not finite where two values are equal.
double Bracket::quadratic() const {
  const double a = f_inside_, b = f_outside_, c = f_before_;
  const double ab = a - b, ac = a - c, bc = b - c;
  return inside_ +
         a * ((before_ - inside_) * (b * ab) - (outside_ - inside_) * (c * ac)) / (ab * ac * bc);
}

}  // namespace slipstick
