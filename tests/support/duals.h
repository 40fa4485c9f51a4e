#pragma once

#include <optional>

#include "core/base/vec.h"
#include "core/expr/graph.h"

namespace slipstick::test {

/// A value with its gradient, in more digits than what it is the oracle of.
struct Dual {
  long double value = 0, x = 0, y = 0, z = 0;
};

/// `root` and its gradient at `p`, node by node; nothing where it is undefined or not
/// differentiable.
[[nodiscard]] std::optional<Dual> dual_of(const Graph& graph, Graph::Id root, Vec3 p);

}  // namespace slipstick::test
