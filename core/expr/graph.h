#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/affine.h"

namespace slipstick {

/// What a node of an expression does. NaN in any operand of arithmetic gives NaN, of `kMin` and
/// `kMax` too, so that it is noticed.
enum class Op : std::uint8_t {
  kConstant,
  kX,
  kY,
  kZ,
  kNegate,
  kAbs,
  kSquare,
  kSqrt,
  kFloor,
  kCeil,
  kRound,
  kSin,
  kCos,
  kTan,
  kAsin,
  kAcos,
  kAtan,
  kExp,
  kLn,
  kNot,  ///< 1 if 0, else 0
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kMin,
  kMax,
  kAtan2,
  kCompare,  ///< -1, 0 or 1
  kModulo,   ///< Euclidean remainder
  kAnd,      ///< a if a is 0, else b
  kOr,       ///< b if a is 0, else a
};

[[nodiscard]] constexpr bool is_unary(Op op) {
  return op >= Op::kNegate && op <= Op::kNot;
}
[[nodiscard]] constexpr bool is_binary(Op op) {
  return op >= Op::kAdd;
}

/// The value of one operation; the definition that every evaluator agrees with bit for bit.
[[nodiscard]] double apply(Op op, double a, double b);

/// An arithmetic expression in x, y and z as a graph: equal subexpressions are one node, operations
/// on constants are folded, operands come before their users.
class Graph {
 public:
  using Id = std::uint32_t;
  struct Node {
    Op op = Op::kConstant;
    Id a = 0;
    Id b = 0;
    double value = 0;
  };

  [[nodiscard]] Id constant(double value);
  [[nodiscard]] Id variable(Op op);
  [[nodiscard]] Id unary(Op op, Id a);
  [[nodiscard]] Id binary(Op op, Id a, Id b);

  [[nodiscard]] const Node& operator[](Id id) const { return nodes_[id]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

  /// `root` with x, y, z replaced.
  [[nodiscard]] Id substituted(Id root, Id x, Id y, Id z);

  /// `root` as seen through `map`: f(map(p)).
  [[nodiscard]] Id mapped(Id root, const Affine3& map);

  /// Nodes that `root` depends on, itself included, operands first.
  [[nodiscard]] std::vector<Id> order(Id root) const;

 private:
  struct Hash {
    std::size_t operator()(const Node& node) const;
  };
  struct Same {
    bool operator()(const Node& a, const Node& b) const;
  };

  [[nodiscard]] Id intern(const Node& node);

  std::vector<Node> nodes_;
  std::unordered_map<Node, Id, Hash, Same> known_;
};

}  // namespace slipstick
