#include "core/expr/graph.h"

#include <bit>
#include <cmath>

#include "core/base/check.h"
#include "core/base/elementary.h"

namespace slipstick {
namespace {

double lesser(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return a + b;
  return b < a ? b : a;
}

double greater(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return a + b;
  return b > a ? b : a;
}

double compare(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return a + b;
  return a < b ? -1 : a > b ? 1 : 0;
}

double modulo(double a, double b) {
  const double rest = std::fmod(a, b);
  return rest < 0 ? rest + std::abs(b) : rest;
}

double apply_unary(Op op, double a) {
  switch (op) {
    case Op::kNegate:
      return -a;
    case Op::kAbs:
      return std::abs(a);
    case Op::kSquare:
      return a * a;
    case Op::kSqrt:
      return std::sqrt(a);
    case Op::kFloor:
      return std::floor(a);
    case Op::kCeil:
      return std::ceil(a);
    case Op::kRound:
      return std::round(a);
    case Op::kSin:
      return sine(a);
    case Op::kCos:
      return cosine(a);
    case Op::kTan:
      return tangent(a);
    case Op::kAsin:
      return arc_sine(a);
    case Op::kAcos:
      return arc_cosine(a);
    case Op::kAtan:
      return arc_tangent(a);
    case Op::kExp:
      return exponential(a);
    case Op::kLn:
      return natural_logarithm(a);
    default:
      return a == 0 ? 1 : 0;
  }
}

}  // namespace

double apply(Op op, double a, double b) {
  switch (op) {
    case Op::kAdd:
      return a + b;
    case Op::kSubtract:
      return a - b;
    case Op::kMultiply:
      return a * b;
    case Op::kDivide:
      return a / b;
    case Op::kMin:
      return lesser(a, b);
    case Op::kMax:
      return greater(a, b);
    case Op::kAtan2:
      return arc_tangent(a, b);
    case Op::kCompare:
      return compare(a, b);
    case Op::kModulo:
      return modulo(a, b);
    case Op::kAnd:
      return a == 0 ? a : b;
    case Op::kOr:
      return a == 0 ? b : a;
    default:
      return apply_unary(op, a);
  }
}

std::size_t Graph::Hash::operator()(const Node& node) const {
  std::uint64_t h = std::bit_cast<std::uint64_t>(node.value) ^ static_cast<std::uint64_t>(node.op);
  for (const std::uint64_t part : {std::uint64_t{node.a}, std::uint64_t{node.b}}) {
    h = (h ^ part) * 0x9E3779B97F4A7C15u;
    h ^= h >> 29;
  }
  return h;
}

// Bits, not values: -0 and 0 are two constants, and NaN is one.
bool Graph::Same::operator()(const Node& a, const Node& b) const {
  return a.op == b.op && a.a == b.a && a.b == b.b &&
         std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

Graph::Id Graph::intern(const Node& node) {
  const auto [at, is_new] = known_.try_emplace(node, static_cast<Id>(nodes_.size()));
  if (is_new) nodes_.push_back(node);
  return at->second;
}

Graph::Id Graph::constant(double value) {
  return intern({Op::kConstant, 0, 0, value});
}

Graph::Id Graph::variable(Op op) {
  SLIPSTICK_CHECK(op == Op::kX || op == Op::kY || op == Op::kZ);
  return intern({op, 0, 0, 0});
}

Graph::Id Graph::unary(Op op, Id a) {
  SLIPSTICK_CHECK(is_unary(op) && a < nodes_.size());
  if (nodes_[a].op == Op::kConstant) return constant(apply(op, nodes_[a].value, 0));
  return intern({op, a, 0, 0});
}

Graph::Id Graph::binary(Op op, Id a, Id b) {
  SLIPSTICK_CHECK(is_binary(op) && a < nodes_.size() && b < nodes_.size());
  if (nodes_[a].op == Op::kConstant && nodes_[b].op == Op::kConstant) {
    return constant(apply(op, nodes_[a].value, nodes_[b].value));
  }
  if (a == b && (op == Op::kMin || op == Op::kMax)) return a;
  return intern({op, a, b, 0});
}

std::vector<Graph::Id> Graph::order(Id root) const {
  std::vector<bool> needed(root + 1);
  needed[root] = true;
  for (Id id = root + 1; id-- > 0;) {
    if (!needed[id]) continue;
    const Node& node = nodes_[id];
    if (is_unary(node.op) || is_binary(node.op)) needed[node.a] = true;
    if (is_binary(node.op)) needed[node.b] = true;
  }
  std::vector<Id> result;
  for (Id id = 0; id <= root; ++id) {
    if (needed[id]) result.push_back(id);
  }
  return result;
}

Graph::Id Graph::substituted(Id root, Id x, Id y, Id z) {
  std::vector<Id> now(root + 1);
  for (const Id id : order(root)) {
    const Node node = nodes_[id];  // a copy: nodes_ grows
    switch (node.op) {
      case Op::kConstant:
        now[id] = id;
        break;
      case Op::kX:
        now[id] = x;
        break;
      case Op::kY:
        now[id] = y;
        break;
      case Op::kZ:
        now[id] = z;
        break;
      default:
        now[id] = is_binary(node.op) ? binary(node.op, now[node.a], now[node.b])
                                     : unary(node.op, now[node.a]);
    }
  }
  return now[root];
}

Graph::Id Graph::mapped(Id root, const Affine3& map) {
  const std::array<Id, 3> variables{variable(Op::kX), variable(Op::kY), variable(Op::kZ)};
  std::array<Id, 3> images{};
  for (std::size_t i = 0; i < 3; ++i) {
    Id sum = constant(map.rows[i][3]);
    for (std::size_t j = 0; j < 3; ++j) {
      const double factor = map.rows[i][j];
      if (factor == 0) continue;
      const Id term =
          factor == 1 ? variables[j] : binary(Op::kMultiply, constant(factor), variables[j]);
      sum = binary(Op::kAdd, term, sum);
    }
    images[i] = sum;
  }
  return substituted(root, images[0], images[1], images[2]);
}

}  // namespace slipstick
