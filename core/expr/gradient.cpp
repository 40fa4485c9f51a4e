#include "core/expr/gradient.h"

#include <algorithm>
#include <cmath>

#include "core/expr/gradient_norm.h"
#include "core/expr/gradient_rules.h"

namespace slipstick {
namespace {

using Slopes = GradientEvaluator::Slopes;

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
                    ? leaf_range(step, box)
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

Slopes hulls(const Slopes& a, const Slopes& b) {
  Slopes result;
  for (std::size_t d = 0; d < result.size(); ++d) result[d] = hull(a[d], b[d]);
  return result;
}

Slopes in_both(const Slopes& a, const Slopes& b) {
  Slopes result;
  for (std::size_t d = 0; d < result.size(); ++d) {
    result[d] = {std::max(a[d].low, b[d].low), std::min(a[d].high, b[d].high)};
  }
  return result;
}

// Nothing that certificates ask for is left to be known, however little is added.
bool hopeless(const Slopes& s) {
  return std::none_of(s.begin(), s.end(), [](Slope d) { return d.never_zero(); }) &&
         !s[2].never_falls() && !s[2].never_rises();
}

}  // namespace

GradientRange GradientEvaluator::over(const Tape& tape, const Box3& box) {
  fill_values(tape, box, values_);
  if (values_.back().may_be_nan) return {};
  const Slopes s = slopes_of_all_branches(tape);
  GradientRange range{values_.back(), s[0], s[1], s[2], s[3], s[4]};
  if (range.no_surface()) return range;
  const Vec3 centre = middle(box);
  fill_values(tape, {centre, centre}, values_);
  if (!values_.back().may_be_nan) range.value = mean_value(values_.back(), range, box);
  return range;
}

// Depth first: the last choice that was not turned yet is turned, those after it forgotten.
Slopes GradientEvaluator::slopes_of_all_branches(const Tape& tape) {
  choices_.clear();
  Slopes all = slopes_of_branch(tape, Creases::kChosen);
  while (true) {
    while (!choices_.empty() && choices_.back().turned) choices_.pop_back();
    if (choices_.empty()) return all;
    if (hopeless(all)) return slopes_of_branch(tape, Creases::kHull);
    choices_.back().turned = true;
    all = hulls(all, slopes_of_branch(tape, Creases::kChosen));
  }
}

Slopes GradientEvaluator::slopes_of_branch(const Tape& tape, Creases creases) {
  slopes_.resize(tape.steps.size());
  stands_for_.resize(tape.steps.size());
  for (std::uint32_t i = 0; i < tape.steps.size(); ++i) {
    const Tape::Step& step = tape.steps[i];
    stands_for_[i] = i;
    if (is_leaf(step.op)) {
      slopes_[i] = leaf_slopes(step.op);
      continue;
    }
    const auto operand = creases == Creases::kChosen ? chosen(step) : std::nullopt;
    if (operand) stands_for_[i] = *operand;
    slopes_[i] = operand ? slopes_[*operand] : slopes_of_step(tape, i);
  }
  return slopes_.back();
}

Slopes GradientEvaluator::slopes_of_step(const Tape& tape, std::uint32_t i) const {
  const Tape::Step& step = tape.steps[i];
  if (values_[i].may_be_nan) return Slopes{};
  const std::uint32_t b = is_binary(step.op) ? step.b : step.a;
  const Slopes ruled = differentiated(
      step.op, {values_[step.a], values_[b], values_[i], slopes_[step.a], slopes_[b]});
  const auto length = length_slopes(tape, i, values_, slopes_);
  return length ? in_both(ruled, *length) : ruled;
}

// Which operand of a min or max is taken in this branch; nothing for other steps and for those that
// are one too many. The same two operands are always decided alike: max(q, 0) and min(q, 0) are q
// and 0, or 0 and q.
std::optional<std::uint32_t> GradientEvaluator::chosen(const Tape::Step& step) {
  if (step.op != Op::kMin && step.op != Op::kMax) return {};
  const std::uint32_t a = stands_for_[step.a], b = stands_for_[step.b];
  if (a == b) return a;
  const Interval &v = values_[step.a], &w = values_[step.b];
  if (v.high < w.low) return step.op == Op::kMin ? a : b;
  if (w.high < v.low) return step.op == Op::kMin ? b : a;
  const std::uint32_t first = std::min(a, b), second = std::max(a, b);
  auto choice = std::find_if(choices_.begin(), choices_.end(), [=](const Choice& c) {
    return c.first == first && c.second == second;
  });
  if (choice == choices_.end()) {
    if (choices_.size() == kChoicesMax) return {};
    choice = choices_.insert(choice, {first, second, false});
  }
  const bool first_is_greater = choice->turned;
  return first_is_greater == (step.op == Op::kMax) ? first : second;
}

}  // namespace slipstick
