#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/expr/slope.h"
#include "core/expr/tape.h"

namespace slipstick {

/// What a function and its derivatives are over a box.
///
/// Where the function has creases (min, max, abs) the slopes hold Clarke's generalised gradient:
/// the hull of the gradients on all sides. That 0 is not in it is enough for what gradients are
/// asked for here: a level set of a Lipschitz function whose Clarke gradient has no 0 in a
/// direction is there the graph of a Lipschitz function over the plane across that direction
/// (Clarke's implicit function theorem, 1983, 7.1), as it would be for a smooth one. Where the
/// function may jump, or be steep without bound, all slopes are the whole line.
struct GradientRange {
  Interval value;
  Slope x, y, z;
  Slope rising;   ///< Along (1, 1, 0), that is x + y, but tighter than the sum of the two.
  Slope falling;  ///< Along (-1, 1, 0).

  /// No point of the box has f = 0.
  [[nodiscard]] bool no_surface() const {
    return !value.may_be_nan && (value.low > 0 || value.high < 0);
  }
};

/// Forward-mode gradients of tapes over boxes; keeps its memory from call to call.
class GradientEvaluator {
 public:
  /// The range of `tape` over `box` as real numbers: rounding errors of a point evaluator are not
  /// part of it. The value is the better of the intervals operation by operation and the mean value
  /// form f(c) + f'(box)·(box - c), which is tighter in small boxes. Slopes are the hull over the
  /// branches of the function: its Clarke gradient is in the hull of the gradients of its pieces.
  [[nodiscard]] GradientRange over(const Tape& tape, const Box3& box);

  /// Directions of which slopes are kept: x, y, z, x + y, y - x.
  static constexpr std::size_t kDirections = 5;
  using Slopes = std::array<Slope, kDirections>;

  /// Undecided pairs of min and max that are taken apart into branches, each with slopes of its
  /// own; for more of them, the hull of both operands.
  static constexpr std::size_t kChoicesMax = 6;

 private:
  enum class Creases : std::uint8_t { kChosen, kHull };
  // Of two operands, whether the first is the greater in this branch.
  struct Choice {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    bool turned = false;
  };

  [[nodiscard]] Slopes slopes_of_all_branches(const Tape& tape);
  [[nodiscard]] Slopes slopes_of_branch(const Tape& tape, Creases creases);
  [[nodiscard]] Slopes slopes_of_step(const Tape& tape, std::uint32_t i) const;
  [[nodiscard]] std::optional<std::uint32_t> chosen(const Tape::Step& step);

  std::vector<Interval> values_;
  std::vector<Slopes> slopes_;
  std::vector<std::uint32_t> stands_for_;
  std::vector<Choice> choices_;
};

}  // namespace slipstick
