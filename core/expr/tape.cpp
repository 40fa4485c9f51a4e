#include "core/expr/tape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/check.h"

namespace slipstick {
namespace {

constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

// The steps that `root` needs, renumbered.
Tape live_part(const std::vector<Tape::Step>& steps, std::uint32_t root) {
  std::vector<std::uint32_t> number(root + 1, kAbsent);
  number[root] = 0;
  for (std::uint32_t i = root + 1; i-- > 0;) {
    if (number[i] == kAbsent) continue;
    if (is_unary(steps[i].op) || is_binary(steps[i].op)) number[steps[i].a] = 0;
    if (is_binary(steps[i].op)) number[steps[i].b] = 0;
  }
  Tape tape;
  for (std::uint32_t i = 0; i <= root; ++i) {
    if (number[i] == kAbsent) continue;
    number[i] = static_cast<std::uint32_t>(tape.steps.size());
    Tape::Step step = steps[i];
    if (is_unary(step.op) || is_binary(step.op)) step.a = number[step.a];
    if (is_binary(step.op)) step.b = number[step.b];
    tape.steps.push_back(step);
  }
  return tape;
}

Interval value_of(const Tape::Step& step, const Box3& box, const std::vector<Interval>& values) {
  if (!is_unary(step.op) && !is_binary(step.op)) return leaf_range(step, box);
  return apply(step.op, values[step.a], values[is_binary(step.op) ? step.b : step.a]);
}

// Which operand of a min or max wins everywhere, if one does. Equal bounds decide nothing: -0 and 0
// are equal but not the same bits.
std::optional<std::uint32_t> winner(const Tape::Step& step, const std::vector<Interval>& values) {
  if (step.op != Op::kMin && step.op != Op::kMax) return {};
  const Interval& a = values[step.a];
  const Interval& b = values[step.b];
  if (a.may_be_nan || b.may_be_nan) return {};
  if (a.high < b.low) return step.op == Op::kMin ? step.a : step.b;
  if (b.high < a.low) return step.op == Op::kMin ? step.b : step.a;
  return {};
}

using Values = double* __restrict;
using Operand = const double*;

template <typename F>
void each(std::size_t n, Values out, Operand a, F f) {
  for (std::size_t i = 0; i < n; ++i) out[i] = f(a[i]);
}

template <typename F>
void each(std::size_t n, Values out, Operand a, Operand b, F f) {
  for (std::size_t i = 0; i < n; ++i) out[i] = f(a[i], b[i]);
}

// The common operations in loops that the compiler turns into vectors; the rest one by one. Same
// bits.
void run_step(const Tape::Step& step, std::size_t n, Values out, Operand a, Operand b) {
  switch (step.op) {
    case Op::kAdd:
      return each(n, out, a, b, [](double p, double q) { return p + q; });
    case Op::kSubtract:
      return each(n, out, a, b, [](double p, double q) { return p - q; });
    case Op::kMultiply:
      return each(n, out, a, b, [](double p, double q) { return p * q; });
    case Op::kDivide:
      return each(n, out, a, b, [](double p, double q) { return p / q; });
    case Op::kNegate:
      return each(n, out, a, [](double p) { return -p; });
    case Op::kAbs:
      return each(n, out, a, [](double p) { return std::abs(p); });
    case Op::kSquare:
      return each(n, out, a, [](double p) { return p * p; });
    case Op::kMin:
      return each(n, out, a, b, [](double p, double q) {
        const double least = q < p ? q : p;
        return p != p || q != q ? p + q : least;
      });
    case Op::kMax:
      return each(n, out, a, b, [](double p, double q) {
        const double most = q > p ? q : p;
        return p != p || q != q ? p + q : most;
      });
    default:
      return each(n, out, a, b, [op = step.op](double p, double q) { return apply(op, p, q); });
  }
}

// The value of an operation on constants.
std::optional<double> constant_of(const Tape::Step& step, const std::vector<Tape::Step>& steps) {
  if (!is_unary(step.op) && !is_binary(step.op)) return {};
  const Tape::Step& a = steps[step.a];
  const Tape::Step& b = is_binary(step.op) ? steps[step.b] : a;
  if (a.op != Op::kConstant || b.op != Op::kConstant) return {};
  return apply(step.op, a.value, b.value);
}

}  // namespace

Interval leaf_range(const Tape::Step& step, const Box3& box) {
  switch (step.op) {
    case Op::kX:
      return Interval::of(box.low.x, box.high.x);
    case Op::kY:
      return Interval::of(box.low.y, box.high.y);
    case Op::kZ:
      return Interval::of(box.low.z, box.high.z);
    default:
      return std::isnan(step.value) ? Interval::anything() : Interval::of(step.value, step.value);
  }
}

Tape compile(const Graph& graph, Graph::Id root) {
  const std::vector<Graph::Id> order = graph.order(root);
  Tape tape;
  tape.steps.reserve(order.size());
  std::vector<std::uint32_t> step_of(root + 1, kAbsent);
  for (const Graph::Id id : order) {
    const Graph::Node& node = graph[id];
    Tape::Step step{node.op, 0, 0, node.value};
    if (is_unary(node.op) || is_binary(node.op)) step.a = step_of[node.a];
    if (is_binary(node.op)) step.b = step_of[node.b];
    step_of[id] = static_cast<std::uint32_t>(tape.steps.size());
    tape.steps.push_back(step);
  }
  return tape;
}

Tape at_height(Tape tape, double z) {
  for (Tape::Step& step : tape.steps) {
    if (step.op == Op::kZ) {
      step = {Op::kConstant, 0, 0, z};
    } else if (const auto value = constant_of(step, tape.steps)) {
      step = {Op::kConstant, 0, 0, *value};
    }
  }
  return tape;
}

Pruned prune(const Tape& tape, const Box3& box) {
  const auto count = static_cast<std::uint32_t>(tape.steps.size());
  std::vector<Interval> values(count);
  std::vector<std::uint32_t> stands_for(count);
  std::vector<Tape::Step> steps = tape.steps;
  bool shorter = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    values[i] = value_of(tape.steps[i], box, values);
    const auto won = winner(tape.steps[i], values);
    shorter |= won.has_value();
    stands_for[i] = won ? stands_for[*won] : i;
    if (is_unary(steps[i].op) || is_binary(steps[i].op)) steps[i].a = stands_for[steps[i].a];
    if (is_binary(steps[i].op)) steps[i].b = stands_for[steps[i].b];
  }
  const Interval range = values[count - 1];
  if (!shorter) return {range, {}};
  return {range, live_part(steps, stands_for[count - 1])};
}

std::span<const double> TapeEvaluator::evaluate(const Tape& tape, std::span<const double> xs,
                                                std::span<const double> ys, double z) {
  const std::size_t n = xs.size();
  SLIPSTICK_CHECK(n <= kPointsMax && ys.size() == n);
  values_.resize(std::max(values_.size(), tape.steps.size() * kPointsMax));
  const auto at = [this](std::size_t step) { return values_.data() + step * kPointsMax; };
  for (std::size_t i = 0; i < tape.steps.size(); ++i) {
    const Tape::Step& step = tape.steps[i];
    switch (step.op) {
      case Op::kConstant:
        std::fill_n(at(i), n, step.value);
        break;
      case Op::kX:
        std::copy(xs.begin(), xs.end(), at(i));
        break;
      case Op::kY:
        std::copy(ys.begin(), ys.end(), at(i));
        break;
      case Op::kZ:
        std::fill_n(at(i), n, z);
        break;
      default:
        run_step(step, n, at(i), at(step.a), at(is_binary(step.op) ? step.b : step.a));
    }
  }
  return {at(tape.steps.size() - 1), n};
}

}  // namespace slipstick
