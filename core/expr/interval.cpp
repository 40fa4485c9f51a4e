#include "core/expr/interval.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "core/base/elementary.h"

namespace slipstick {
namespace {

using std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Basic operations and the square root are rounded correctly: one unit in the last place covers the
// interval's own rounding.
constexpr int kBasicUlps = 1;
// An elementary function at a point may be too large and at the end of the interval too small, each
// by its error; and a unit of the one may be two of the other.
constexpr int kElementarySlack = 4 * kElementaryUlps;

double margin(double value, int ulps) {
  return ulps * (std::abs(value) * 0x1p-52 + std::numeric_limits<double>::denorm_min());
}

double down(double value, int ulps) {
  return std::isinf(value) ? std::nextafter(value, -kInfinity) : value - margin(value, ulps);
}

double up(double value, int ulps) {
  return std::isinf(value) ? std::nextafter(value, kInfinity) : value + margin(value, ulps);
}

// A product or quotient of numbers that are not 0 may round to 0, which then is not its bound.
double not_vanished(double result, double a, double b) {
  if (result != 0 || a == 0 || b == 0) return result;
  return std::copysign(std::numeric_limits<double>::denorm_min(), result);
}

// Otherwise rounding never changes a sign, so neither does widening: without that, the root of a
// sum of squares would be undefined wherever both may be 0.
Interval widened(double low, double high, int ulps) {
  if (std::isnan(low) || std::isnan(high)) return Interval::anything();
  const double wider_low = down(low, ulps), wider_high = up(high, ulps);
  return Interval::of(low >= 0 ? std::max(wider_low, 0.0) : wider_low,
                      high <= 0 ? std::min(wider_high, 0.0) : wider_high);
}

Interval around(std::initializer_list<double> corners, int ulps) {
  double low = kInfinity, high = -kInfinity;
  for (const double c : corners) {
    if (std::isnan(c)) return Interval::anything();
    low = std::min(low, c);
    high = std::max(high, c);
  }
  return widened(low, high, ulps);
}

Interval square(const Interval& a) {
  const double l = a.low * a.low, h = a.high * a.high;
  if (a.low <= 0 && a.high >= 0) return Interval::of(0, up(std::max(l, h), kBasicUlps));
  return Interval::of(std::max(0.0, down(std::min(l, h), kBasicUlps)),
                      up(std::max(l, h), kBasicUlps));
}

Interval absolute(const Interval& a) {
  if (a.low >= 0) return a;
  if (a.high <= 0) return Interval::of(-a.high, -a.low);
  return Interval::of(0, std::max(-a.low, a.high));
}

Interval quotient(const Interval& a, const Interval& b) {
  if (b.low <= 0 && b.high >= 0) return Interval::anything();
  const auto over = [](double p, double q) { return not_vanished(p / q, p, q); };
  return around(
      {over(a.low, b.low), over(a.low, b.high), over(a.high, b.low), over(a.high, b.high)},
      kBasicUlps);
}

Interval product(const Interval& a, const Interval& b) {
  const auto times = [](double p, double q) { return not_vanished(p * q, p, q); };
  return around(
      {times(a.low, b.low), times(a.low, b.high), times(a.high, b.low), times(a.high, b.high)},
      kBasicUlps);
}

// Whether some peak + 2πk lies in the interval, with room for rounding: saying yes is always safe.
bool holds_peak(const Interval& a, double peak) {
  const double slack = 1e-9 * (1 + std::max(std::abs(a.low), std::abs(a.high)));
  const double k = std::ceil((a.low - slack - peak) / (2 * pi));
  return peak + 2 * pi * k <= a.high + slack;
}

Interval wave(double (*f)(double), const Interval& a, double top) {
  constexpr double kReach = 1e6;  // beyond, reduction by 2π is not worth its care
  if (!(a.low > -kReach && a.high < kReach)) {
    if (std::isinf(a.low) || std::isinf(a.high)) return Interval::anything();
    return Interval::of(-1, 1);
  }
  const Interval ends = around({f(a.low), f(a.high)}, kElementarySlack);
  return Interval::of(holds_peak(a, top + pi) ? -1 : std::max(ends.low, -1.0),
                      holds_peak(a, top) ? 1 : std::min(ends.high, 1.0));
}

Interval tangent_over(const Interval& a) {
  constexpr double kSafe = 1.5;  // inside the first branch
  if (a.low < -kSafe || a.high > kSafe) return Interval::anything();
  return widened(tangent(a.low), tangent(a.high), kElementarySlack);
}

Interval rising(double (*f)(double), const Interval& a, double domain_low, double domain_high) {
  if (a.low < domain_low || a.high > domain_high) return Interval::anything();
  return widened(f(a.low), f(a.high), kElementarySlack);
}

double down_to_whole(double a) {
  return std::floor(a);
}
double up_to_whole(double a) {
  return std::ceil(a);
}
double to_whole(double a) {
  return std::round(a);
}

// However small, it is more than 0.
double exponential_above_zero(double a) {
  return std::max(exponential(a), std::numeric_limits<double>::denorm_min());
}

Interval exponential_over(const Interval& a) {
  const Interval range = rising(exponential_above_zero, a, -kInfinity, kInfinity);
  return Interval::of(std::max(range.low, 0.0), range.high);
}

Interval arc_cosine_over(const Interval& a) {
  if (a.low < -1 || a.high > 1) return Interval::anything();
  return widened(arc_cosine(a.high), arc_cosine(a.low), kElementarySlack);
}

Interval unary(Op op, const Interval& a) {
  switch (op) {
    case Op::kNegate:
      return Interval::of(-a.high, -a.low);
    case Op::kAbs:
      return absolute(a);
    case Op::kSquare:
      return square(a);
    case Op::kSqrt:
      return rising(std::sqrt, a, 0, kInfinity);
    case Op::kFloor:
      return Interval::of(down_to_whole(a.low), down_to_whole(a.high));
    case Op::kCeil:
      return Interval::of(up_to_whole(a.low), up_to_whole(a.high));
    case Op::kRound:
      return Interval::of(to_whole(a.low), to_whole(a.high));
    case Op::kSin:
      return wave(sine, a, pi / 2);
    case Op::kCos:
      return wave(cosine, a, 0);
    case Op::kTan:
      return tangent_over(a);
    case Op::kAsin:
      return rising(arc_sine, a, -1, 1);
    case Op::kAcos:
      return arc_cosine_over(a);
    case Op::kAtan:
      return rising(arc_tangent, a, -kInfinity, kInfinity);
    case Op::kExp:
      return exponential_over(a);
    case Op::kLn:
      return rising(natural_logarithm, a, 0, kInfinity);
    default:
      return Interval::of(0, 1);
  }
}

Interval modulo(const Interval& b) {
  const double most = std::max(std::abs(b.low), std::abs(b.high));
  if (b.low <= 0 && b.high >= 0) return Interval::anything();
  return Interval::of(0, most);
}

Interval compare(const Interval& a, const Interval& b) {
  return Interval::of(a.low > b.high    ? 1
                      : a.low >= b.high ? 0
                                        : -1,
                      a.high < b.low    ? -1
                      : a.high <= b.low ? 0
                                        : 1);
}

bool bounded(const Interval& a) {
  return std::isfinite(a.low) && std::isfinite(a.high);
}

// Operations that give NaN for some infinite operand: ∞ - ∞, 0·∞, ∞/∞, the remainder of ∞.
bool may_cancel(Op op) {
  return op == Op::kAdd || op == Op::kSubtract || op == Op::kMultiply || op == Op::kDivide ||
         op == Op::kModulo;
}

}  // namespace

Interval apply(Op op, const Interval& a, const Interval& b) {
  if (a.may_be_nan || (is_binary(op) && b.may_be_nan)) return Interval::anything();
  if (may_cancel(op) && !(bounded(a) && bounded(b))) return Interval::anything();
  switch (op) {
    case Op::kAdd:
      return widened(a.low + b.low, a.high + b.high, kBasicUlps);
    case Op::kSubtract:
      return widened(a.low - b.high, a.high - b.low, kBasicUlps);
    case Op::kMultiply:
      return product(a, b);
    case Op::kDivide:
      return quotient(a, b);
    case Op::kMin:
      return Interval::of(std::min(a.low, b.low), std::min(a.high, b.high));
    case Op::kMax:
      return Interval::of(std::max(a.low, b.low), std::max(a.high, b.high));
    case Op::kAtan2:
      return Interval::of(down(-pi, kElementarySlack), up(pi, kElementarySlack));
    case Op::kCompare:
      return compare(a, b);
    case Op::kModulo:
      return modulo(b);
    case Op::kAnd:
    case Op::kOr:
      return Interval::of(std::min(a.low, b.low), std::max(a.high, b.high));
    default:
      return unary(op, a);
  }
}

}  // namespace slipstick
