#include "core/expr/gradient.h"

#include <cmath>

#include "core/expr/gradient_rules.h"

namespace slipstick {
namespace {

using Slopes = GradientEvaluator::Slopes;

Interval leaf_value(const Tape::Step& step, const Box3& box) {
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

Slopes leaf_slopes(Op op) {
  const Slope none{0, 0}, one{1, 1};
  switch (op) {
    case Op::kX:
      return {one, none, none, one, -one};
    case Op::kY:
      return {none, one, none, one, one};
    case Op::kZ:
      return {none, none, one, none, none};
    default:
      return {none, none, none, none, none};
  }
}

bool is_leaf(Op op) {
  return !is_unary(op) && !is_binary(op);
}

void fill_values(const Tape& tape, const Box3& box, std::vector<Interval>& values) {
  values.resize(tape.steps.size());
  for (std::size_t i = 0; i < tape.steps.size(); ++i) {
    const Tape::Step& step = tape.steps[i];
    values[i] = is_leaf(step.op)
                    ? leaf_value(step, box)
                    : apply(step.op, values[step.a], values[is_binary(step.op) ? step.b : step.a]);
  }
}

// What may be between -reach and reach.
Slope around_zero(double reach) {
  return {-reach, reach};
}

// Half the side, or a little more.
double reach(double low, double high) {
  const double centre = low + (high - low) / 2;
  return std::max(high - centre, centre - low) * (1 + 4 * detail::kStep);
}

Interval mean_value(const Interval& centre, const GradientRange& range, const Box3& box) {
  const Slope spread = Slope{centre.low, centre.high} +
                       range.x * around_zero(reach(box.low.x, box.high.x)) +
                       range.y * around_zero(reach(box.low.y, box.high.y)) +
                       range.z * around_zero(reach(box.low.z, box.high.z));
  return Interval::of(std::max(range.value.low, spread.low),
                      std::min(range.value.high, spread.high));
}

Vec3 middle(const Box3& box) {
  const auto of = [](double low, double high) { return low + (high - low) / 2; };
  return {of(box.low.x, box.high.x), of(box.low.y, box.high.y), of(box.low.z, box.high.z)};
}

}  // namespace

GradientRange GradientEvaluator::over(const Tape& tape, const Box3& box) {
  fill_values(tape, box, values_);
  slopes_.resize(tape.steps.size());
  for (std::size_t i = 0; i < tape.steps.size(); ++i) {
    const Tape::Step& step = tape.steps[i];
    if (is_leaf(step.op)) {
      slopes_[i] = leaf_slopes(step.op);
    } else if (values_[i].may_be_nan) {
      slopes_[i] = Slopes{};
    } else {
      const std::uint32_t b = is_binary(step.op) ? step.b : step.a;
      slopes_[i] = differentiated(
          step.op, {values_[step.a], values_[b], values_[i], slopes_[step.a], slopes_[b]});
    }
  }
  const Slopes& s = slopes_.back();
  GradientRange range{values_.back(), s[0], s[1], s[2], s[3], s[4]};
  if (range.no_surface() || range.value.may_be_nan) return range;
  const Vec3 centre = middle(box);
  fill_values(tape, {centre, centre}, values_);
  if (!values_.back().may_be_nan) range.value = mean_value(values_.back(), range, box);
  return range;
}

}  // namespace slipstick
