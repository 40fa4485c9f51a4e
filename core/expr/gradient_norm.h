#pragma once

#include <optional>
#include <span>

#include "core/expr/gradient.h"

namespace slipstick {

/// Slopes of a length, step `root` = sqrt(a² + b² + …), also where it may be 0 and the chain rule
/// divides by it. The gradient is u·(a', b', …) for some |u| <= 1, and what is known of the signs
/// of a, b, … is known of u. \return Nothing if the step is no such root.
[[nodiscard]] std::optional<GradientEvaluator::Slopes> length_slopes(
    const Tape& tape, std::size_t root, std::span<const Interval> values,
    std::span<const GradientEvaluator::Slopes> slopes);

}  // namespace slipstick
