#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/box.h"
#include "core/expr/graph.h"
#include "core/expr/interval.h"

namespace slipstick {

/// An expression as a list of steps; step i writes value i, the last is the result.
struct Tape {
  struct Step {
    Op op = Op::kConstant;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    double value = 0;
  };
  std::vector<Step> steps;
};

/// The values of a constant or a coordinate over a box.
[[nodiscard]] Interval leaf_range(const Tape::Step& step, const Box3& box);

/// `root` in space.
[[nodiscard]] Tape compile(const Graph& graph, Graph::Id root);

/// The same in the plane at `z`, step for step: whatever depends on z alone is a constant, and what
/// that was made of is left in.
[[nodiscard]] Tape at_height(Tape tape, double z);

/// What a tape is over a box: all its values, and a tape without the branches of min and max that
/// lose everywhere in the box. The shorter tape gives bit-identical values there, because min and
/// max give exactly one of their operands.
struct Pruned {
  Interval range;
  Tape tape;  ///< Empty: nothing could be left out.
};
[[nodiscard]] Pruned prune(const Tape& tape, const Box3& box);

/// Evaluates tapes; keeps its memory from call to call.
class TapeEvaluator {
 public:
  /// The tape at the points (xs[i], ys[i], z). \return As many values, good until the next call.
  /// \pre One length, at most `kPointsMax`.
  [[nodiscard]] std::span<const double> evaluate(const Tape& tape, std::span<const double> xs,
                                                 std::span<const double> ys, double z);

  static constexpr std::size_t kPointsMax = 64;

 private:
  std::vector<double> values_;
};

}  // namespace slipstick
