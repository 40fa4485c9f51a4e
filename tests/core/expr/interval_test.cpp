// Intervals against random boxes: they hold the exact value, not only the rounded one, and a box
// within another has an interval within the other's.
#include "core/expr/interval.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/elementary.h"
#include "core/base/rng.h"
#include "tests/support/duals.h"

using namespace slipstick;

namespace {

constexpr int kBoxes = 1'000'000;
constexpr Op kOps[] = {Op::kNegate, Op::kAbs, Op::kSquare, Op::kSqrt,     Op::kFloor, Op::kCeil,
                       Op::kRound,  Op::kSin, Op::kCos,    Op::kTan,      Op::kAsin,  Op::kAcos,
                       Op::kAtan,   Op::kExp, Op::kLn,     Op::kNot,      Op::kAdd,   Op::kSubtract,
                       Op::kMin,    Op::kMax, Op::kDivide, Op::kMultiply, Op::kAtan2, Op::kCompare,
                       Op::kModulo, Op::kAnd, Op::kOr};

// Ordinary numbers, very large and very small ones, subnormals, zeros of both signs, infinities.
double drawn(Rng& rng) {
  constexpr double kSpicy[] = {0.0,
                               -0.0,
                               1,
                               -1,
                               std::numeric_limits<double>::denorm_min(),
                               -std::numeric_limits<double>::denorm_min(),
                               std::numeric_limits<double>::min(),
                               std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};
  switch (rng.below(8)) {
    case 0:
      return kSpicy[rng.below(std::size(kSpicy))];
    case 1:
      return std::ldexp(rng.unit() * 2 - 1, static_cast<int>(rng.below(2100)) - 1050);
    default:
      return (rng.unit() * 2 - 1) * std::pow(10, 4 * rng.unit() - 3);
  }
}

Interval drawn_interval(Rng& rng) {
  const double a = drawn(rng), b = rng.below(4) == 0 ? a : drawn(rng);
  return Interval::of(std::min(a, b), std::max(a, b));
}

double point_in(const Interval& i, Rng& rng) {
  switch (rng.below(4)) {
    case 0:
      return i.low;
    case 1:
      return i.high;
    default:
      return std::clamp(i.low + rng.unit() * (i.high - i.low), i.low, i.high);
  }
}

Interval part_of(const Interval& i, Rng& rng) {
  const double a = point_in(i, rng), b = point_in(i, rng);
  return std::isnan(a) || std::isnan(b) ? i : Interval::of(std::min(a, b), std::max(a, b));
}

// What the operation is with more digits and a wider range; nothing where it is infinite, or has no
// slope.
std::optional<long double> exact(Op op, double a, double b) {
  if (op == Op::kModulo) return {};  // a quotient of more digits than even these
  Graph graph;
  const Graph::Id x = graph.variable(Op::kX);
  const Graph::Id root =
      is_binary(op) ? graph.binary(op, x, graph.variable(Op::kY)) : graph.unary(op, x);
  const auto dual = test::dual_of(graph, root, {a, b, 0});
  return dual ? std::optional(dual->value) : std::nullopt;
}

bool holds(const Interval& i, long double value) {
  return i.may_be_nan || (!std::isnan(value) && i.low <= value && value <= i.high);
}

// Elementary functions rise and fall but for their error.
bool within(const Interval& inner, const Interval& outer) {
  if (outer.may_be_nan) return true;
  const auto slack = [](double v) {
    return std::isinf(v) ? 0 : kElementaryUlps * 0x1p-52 * std::abs(v);
  };
  return !inner.may_be_nan && outer.low - slack(outer.low) <= inner.low &&
         inner.high <= outer.high + slack(outer.high);
}

}  // namespace

TEST_CASE("Intervals of a million boxes hold the rounded and the exact value") {
  Rng rng(31);
  int held = 0;
  for (int i = 0; i < kBoxes; ++i) {
    const Op op = kOps[rng.below(std::size(kOps))];
    const Interval x = drawn_interval(rng), y = drawn_interval(rng);
    const double a = point_in(x, rng), b = point_in(y, rng);
    if (std::isnan(a) || std::isnan(b)) continue;  // the middle of the whole line

    const Interval result = apply(op, x, y);

    const double rounded = apply(op, a, b);
    const long double true_value = exact(op, a, b).value_or(rounded);
    if (holds(result, rounded) && holds(result, true_value)) {
      ++held;
      continue;
    }
    INFO("operation " << static_cast<int>(op) << " of " << a << " in [" << x.low << ", " << x.high
                      << "] and " << b << " in [" << y.low << ", " << y.high << "] in ["
                      << result.low << ", " << result.high << "]");
    REQUIRE(holds(result, rounded));
    REQUIRE(holds(result, true_value));
  }
  CHECK(held > kBoxes * 9 / 10);
}

TEST_CASE("The interval of a part of a box lies within that of the box") {
  Rng rng(32);
  int held = 0;
  for (int i = 0; i < kBoxes; ++i) {
    const Op op = kOps[rng.below(std::size(kOps))];
    const Interval x = drawn_interval(rng), y = drawn_interval(rng);
    const Interval x_part = part_of(x, rng), y_part = part_of(y, rng);

    const Interval whole = apply(op, x, y), part = apply(op, x_part, y_part);

    if (within(part, whole)) {
      ++held;
      continue;
    }
    INFO("operation " << static_cast<int>(op) << " of [" << x_part.low << ", " << x_part.high
                      << "] of [" << x.low << ", " << x.high << "] and [" << y_part.low << ", "
                      << y_part.high << "] of [" << y.low << ", " << y.high << "]: [" << part.low
                      << ", " << part.high << "] not in [" << whole.low << ", " << whole.high
                      << "]");
    REQUIRE(within(part, whole));
  }
  CHECK(held == kBoxes);
}
