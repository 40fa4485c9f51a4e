#include "core/expr/gradient_norm.h"

#include <algorithm>
#include <vector>

namespace slipstick {
namespace {

using Slopes = GradientEvaluator::Slopes;

constexpr std::size_t kTermsMax = 8;

// The steps that are squared and added up in `sum`. False if there is anything else in it.
bool collect_terms(const Tape& tape, std::size_t sum, std::vector<std::uint32_t>& terms) {
  const Tape::Step& step = tape.steps[sum];
  if (step.op == Op::kConstant) return step.value == 0;
  if (step.op == Op::kSquare || (step.op == Op::kMultiply && step.a == step.b)) {
    terms.push_back(step.a);
    return terms.size() <= kTermsMax;
  }
  return step.op == Op::kAdd && collect_terms(tape, step.a, terms) &&
         collect_terms(tape, step.b, terms);
}

// Never negative, not only in this box. A sign that may change where the box ends is no sign: the
// crease there belongs to the box.
bool never_negative(const Tape& tape, std::uint32_t term) {
  const Tape::Step& step = tape.steps[term];
  const auto constant = [&](std::uint32_t s) {
    return tape.steps[s].op == Op::kConstant && tape.steps[s].value >= 0;
  };
  return step.op == Op::kAbs || (step.op == Op::kMax && (constant(step.a) || constant(step.b)));
}

// A term's slope towards where the term grows away from 0.
Slope outward(const Interval& value, bool not_negative, Slope slope) {
  if (value.low > 0 || not_negative) return slope;
  if (value.high < 0) return -slope;
  return hull(slope, -slope);
}

}  // namespace

std::optional<Slopes> length_slopes(const Tape& tape, std::size_t root,
                                    std::span<const Interval> values,
                                    std::span<const Slopes> slopes) {
  std::vector<std::uint32_t> terms;
  if (tape.steps[root].op != Op::kSqrt || !collect_terms(tape, tape.steps[root].a, terms))
    return {};
  std::erase_if(terms, [&](std::uint32_t t) { return values[t].low == 0 && values[t].high == 0; });
  Slopes result;
  for (std::size_t d = 0; d < result.size(); ++d) {
    Slope sum{0, 0}, widest_hull{1, -1};
    for (const std::uint32_t t : terms) {
      const Slope widest = outward(values[t], never_negative(tape, t), slopes[t][d]);
      sum = sum + widest * Slope{0, 1};
      widest_hull = t == terms.front() ? widest : hull(widest_hull, widest);
    }
    // Parts of u that all help add up to at least 1; one term alone is all of u.
    if (terms.size() == 1) sum = widest_hull;
    if (terms.size() > 1 && widest_hull.low >= 0) sum.low = std::max(sum.low, widest_hull.low);
    if (terms.size() > 1 && widest_hull.high <= 0) sum.high = std::min(sum.high, widest_hull.high);
    result[d] = sum;
  }
  return result;
}

}  // namespace slipstick
