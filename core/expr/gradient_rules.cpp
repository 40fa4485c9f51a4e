#include "core/expr/gradient_rules.h"

#include <cmath>

namespace slipstick {
namespace {

using Slopes = GradientEvaluator::Slopes;

Slope slope_of(const Interval& i) {
  if (i.may_be_nan || !std::isfinite(i.low) || !std::isfinite(i.high)) return {};
  return {i.low, i.high};
}

Interval interval(double value) {
  return Interval::of(value, value);
}

template <typename F>
Slopes each(const Slopes& a, F f) {
  Slopes result;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = f(a[i]);
  return result;
}

template <typename F>
Slopes each(const Slopes& a, const Slopes& b, F f) {
  Slopes result;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = f(a[i], b[i]);
  return result;
}

Slopes times(const Slopes& a, const Interval& factor) {
  const Slope f = slope_of(factor);
  return each(a, [f](Slope s) { return s * f; });
}

Slopes negated(const Slopes& a) {
  return each(a, [](Slope s) { return -s; });
}

Slopes hulls(const Slopes& a, const Slopes& b) {
  return each(a, b, [](Slope s, Slope t) { return hull(s, t); });
}

Slopes flat() {
  Slopes none;
  none.fill({0, 0});
  return none;
}

bool holds_zero(const Interval& a) {
  return a.low <= 0 && a.high >= 0;
}

// A kink or a jump at an end of an interval belongs to it: the neighbouring box ends there as well,
// and one of them must see it. So ends count as inside in all of the following.

Slopes absolute(const OperationRange& r) {
  if (r.a.low > 0) return r.a_slopes;
  if (r.a.high < 0) return negated(r.a_slopes);
  return hulls(r.a_slopes, negated(r.a_slopes));
}

// Whether floor has no jump in the interval.
bool between_whole_numbers(const Interval& a) {
  return std::floor(a.low) == std::floor(a.high) && a.low > std::floor(a.low);
}

Slopes steps(const Interval& a) {
  return between_whole_numbers(a) ? flat() : Slopes{};
}

Slopes smaller(Op op, const OperationRange& r) {
  const bool a_wins = op == Op::kMin ? r.a.high < r.b.low : r.a.low > r.b.high;
  const bool b_wins = op == Op::kMin ? r.b.high < r.a.low : r.b.low > r.a.high;
  if (a_wins) return r.a_slopes;
  if (b_wins) return r.b_slopes;
  return hulls(r.a_slopes, r.b_slopes);
}

Slopes product(const OperationRange& r) {
  const Slope a = slope_of(r.a), b = slope_of(r.b);
  return each(r.a_slopes, r.b_slopes, [=](Slope s, Slope t) { return s * b + a * t; });
}

// (a/b)' = (a' - (a/b)·b') / b
Slopes quotient(const OperationRange& r) {
  const Slope q = slope_of(r.result);
  const Slope inverse = slope_of(apply(Op::kDivide, interval(1), r.b));
  return each(r.a_slopes, r.b_slopes, [=](Slope s, Slope t) { return (s + -(q * t)) * inverse; });
}

// 1 / sqrt(1 - a²)
Interval arc_sine_factor(const Interval& a) {
  const Interval rest = apply(Op::kSubtract, interval(1), apply(Op::kSquare, a, a));
  if (!(rest.low > 0)) return Interval::anything();
  return apply(Op::kDivide, interval(1), apply(Op::kSqrt, rest, rest));
}

Interval one_plus_square(const Interval& a) {
  return apply(Op::kAdd, interval(1), apply(Op::kSquare, a, a));
}

// atan2(a, b): jumps where a = 0 and b <= 0.
Slopes angle(const OperationRange& r) {
  if (holds_zero(r.a) && !(r.b.low > 0)) return {};
  const Interval square =
      apply(Op::kAdd, apply(Op::kSquare, r.a, r.a), apply(Op::kSquare, r.b, r.b));
  const Slope inverse = slope_of(apply(Op::kDivide, interval(1), square));
  const Slope a = slope_of(r.a), b = slope_of(r.b);
  return each(r.a_slopes, r.b_slopes,
              [=](Slope s, Slope t) { return (b * s + -(a * t)) * inverse; });
}

// a - k·b, where k is one whole number in all of the box.
Slopes remainder(const OperationRange& r) {
  if (!(r.b.low > 0)) return {};
  const Interval ratio = apply(Op::kDivide, r.a, r.b);
  if (ratio.may_be_nan || !between_whole_numbers(ratio)) return {};
  const double k = std::floor(ratio.low);
  return each(r.a_slopes, r.b_slopes, [k](Slope s, Slope t) { return s + -(t * Slope{k, k}); });
}

// a and b, a or b: one of the two, chosen by whether a is 0.
Slopes choice(Op op, const OperationRange& r) {
  const bool is_zero = r.a.low == 0 && r.a.high == 0;
  if (holds_zero(r.a) && !is_zero) return {};
  return is_zero == (op == Op::kAnd) ? r.a_slopes : r.b_slopes;
}

Slopes comparison(const OperationRange& r) {
  return r.a.high < r.b.low || r.b.high < r.a.low ? flat() : Slopes{};
}

// What the slopes of the operand of a differentiable function are multiplied with.
Interval factor(Op op, const OperationRange& r) {
  switch (op) {
    case Op::kSquare:
      return apply(Op::kMultiply, interval(2), r.a);
    case Op::kSqrt:
      return apply(Op::kDivide, interval(0.5), r.result);
    case Op::kSin:
      return apply(Op::kCos, r.a, r.a);
    case Op::kCos:
      return apply(Op::kNegate, apply(Op::kSin, r.a, r.a), r.a);
    case Op::kTan:
      return one_plus_square(r.result);
    case Op::kAsin:
      return arc_sine_factor(r.a);
    case Op::kAcos:
      return apply(Op::kNegate, arc_sine_factor(r.a), r.a);
    case Op::kAtan:
      return apply(Op::kDivide, interval(1), one_plus_square(r.a));
    case Op::kExp:
      return r.result;
    case Op::kLn:
      return apply(Op::kDivide, interval(1), r.a);
    default:
      return Interval::anything();
  }
}

}  // namespace

Slopes differentiated(Op op, const OperationRange& r) {
  switch (op) {
    case Op::kNegate:
      return negated(r.a_slopes);
    case Op::kAbs:
      return absolute(r);
    case Op::kFloor:
    case Op::kCeil:
      return steps(r.a);
    case Op::kRound:
      return steps(apply(Op::kAdd, r.a, interval(0.5)));
    case Op::kNot:
      return holds_zero(r.a) ? Slopes{} : flat();
    case Op::kAdd:
      return each(r.a_slopes, r.b_slopes, [](Slope s, Slope t) { return s + t; });
    case Op::kSubtract:
      return each(r.a_slopes, r.b_slopes, [](Slope s, Slope t) { return s + -t; });
    case Op::kMultiply:
      return product(r);
    case Op::kDivide:
      return quotient(r);
    case Op::kMin:
    case Op::kMax:
      return smaller(op, r);
    case Op::kAtan2:
      return angle(r);
    case Op::kCompare:
      return comparison(r);
    case Op::kModulo:
      return remainder(r);
    case Op::kAnd:
    case Op::kOr:
      return choice(op, r);
    default:
      return times(r.a_slopes, factor(op, r));
  }
}

}  // namespace slipstick
