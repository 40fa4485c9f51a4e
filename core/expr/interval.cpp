#include "core/expr/interval.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace slipstick {
namespace {

using std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Basic operations and the square root are rounded correctly: one step covers the interval's own
// rounding. glibc's elementary functions are good to about one unit in the last place; four steps
// cover them.
constexpr int kBasicSteps = 1;
constexpr int kLibrarySteps = 4;

double down(double value, int steps) {
  for (int i = 0; i < steps; ++i) value = std::nextafter(value, -kInfinity);
  return value;
}

double up(double value, int steps) {
  for (int i = 0; i < steps; ++i) value = std::nextafter(value, kInfinity);
  return value;
}

// Rounding never changes a sign, so neither does widening: without that, the root of a sum of
// squares would be undefined wherever both may be 0.
Interval widened(double low, double high, int steps) {
  if (std::isnan(low) || std::isnan(high)) return Interval::anything();
  const double wider_low = down(low, steps), wider_high = up(high, steps);
  return Interval::of(low >= 0 ? std::max(wider_low, 0.0) : wider_low,
                      high <= 0 ? std::min(wider_high, 0.0) : wider_high);
}

Interval around(std::initializer_list<double> corners, int steps) {
  double low = kInfinity, high = -kInfinity;
  for (const double c : corners) {
    if (std::isnan(c)) return Interval::anything();
    low = std::min(low, c);
    high = std::max(high, c);
  }
  return widened(low, high, steps);
}

Interval square(const Interval& a) {
  const double l = a.low * a.low, h = a.high * a.high;
  if (a.low <= 0 && a.high >= 0) return Interval::of(0, up(std::max(l, h), kBasicSteps));
  return Interval::of(std::max(0.0, down(std::min(l, h), kBasicSteps)),
                      up(std::max(l, h), kBasicSteps));
}

Interval absolute(const Interval& a) {
  if (a.low >= 0) return a;
  if (a.high <= 0) return Interval::of(-a.high, -a.low);
  return Interval::of(0, std::max(-a.low, a.high));
}

Interval quotient(const Interval& a, const Interval& b) {
  if (b.low <= 0 && b.high >= 0) return Interval::anything();
  return around({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high}, kBasicSteps);
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
  const Interval ends = around({f(a.low), f(a.high)}, kLibrarySteps);
  return Interval::of(holds_peak(a, top + pi) ? -1 : std::max(ends.low, -1.0),
                      holds_peak(a, top) ? 1 : std::min(ends.high, 1.0));
}

Interval tangent(const Interval& a) {
  constexpr double kSafe = 1.5;  // inside the first branch
  if (a.low < -kSafe || a.high > kSafe) return Interval::anything();
  return widened(std::tan(a.low), std::tan(a.high), kLibrarySteps);
}

Interval rising(double (*f)(double), const Interval& a, double domain_low, double domain_high) {
  if (a.low < domain_low || a.high > domain_high) return Interval::anything();
  return widened(f(a.low), f(a.high), kLibrarySteps);
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

Interval arc_cosine(const Interval& a) {
  if (a.low < -1 || a.high > 1) return Interval::anything();
  return widened(std::acos(a.high), std::acos(a.low), kLibrarySteps);
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
      return wave(std::sin, a, pi / 2);
    case Op::kCos:
      return wave(std::cos, a, 0);
    case Op::kTan:
      return tangent(a);
    case Op::kAsin:
      return rising(std::asin, a, -1, 1);
    case Op::kAcos:
      return arc_cosine(a);
    case Op::kAtan:
      return rising(std::atan, a, -kInfinity, kInfinity);
    case Op::kExp:
      return rising(std::exp, a, -kInfinity, kInfinity);
    case Op::kLn:
      return rising(std::log, a, 0, kInfinity);
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
      return widened(a.low + b.low, a.high + b.high, kBasicSteps);
    case Op::kSubtract:
      return widened(a.low - b.high, a.high - b.low, kBasicSteps);
    case Op::kMultiply:
      return around({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high}, kBasicSteps);
    case Op::kDivide:
      return quotient(a, b);
    case Op::kMin:
      return Interval::of(std::min(a.low, b.low), std::min(a.high, b.high));
    case Op::kMax:
      return Interval::of(std::max(a.low, b.low), std::max(a.high, b.high));
    case Op::kAtan2:
      return Interval::of(down(-pi, kLibrarySteps), up(pi, kLibrarySteps));
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
