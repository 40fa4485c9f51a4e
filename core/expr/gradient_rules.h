#pragma once

#include "core/expr/gradient.h"

namespace slipstick {

/// What is known of an operation over a box: its operands, its result, the operands' slopes. For a
/// unary operation b is a.
struct OperationRange {
  const Interval& a;
  const Interval& b;
  const Interval& result;
  const GradientEvaluator::Slopes& a_slopes;
  const GradientEvaluator::Slopes& b_slopes;
};

/// The slopes of the result: the chain rule. \pre None of the values may be NaN; `op` has operands.
[[nodiscard]] GradientEvaluator::Slopes differentiated(Op op, const OperationRange& range);

}  // namespace slipstick
