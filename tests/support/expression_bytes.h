#pragma once

#include <cstdint>
#include <span>

#include "core/base/box.h"
#include "core/expr/graph.h"

namespace slipstick::test {

/// An expression, a box and a lattice width that any bytes stand for.
struct ByteExpression {
  Graph graph;
  Graph::Id root = 0;
  Box3 box;
  double sampling = 0;
};

/// Reads operations in the order of the bytes, at most `kByteStepsMax`; what is missing is 0.
[[nodiscard]] ByteExpression expression_of(std::span<const std::uint8_t> bytes);

inline constexpr int kByteStepsMax = 64;

/// `root` at `p`, node by node, with nothing but `apply`: the slow oracle.
[[nodiscard]] double value_of(const Graph& graph, Graph::Id root, Vec3 p);

/// Whether the two are one number, bit for bit, or both none.
[[nodiscard]] bool same_value(double a, double b);

/// Fails a check unless intervals hold the samples of `e`, shortened tapes give their bits, and the
/// image that is printed is theirs.
void check_against_oracle(const ByteExpression& e);

}  // namespace slipstick::test
