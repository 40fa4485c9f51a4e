#include "tests/support/duals.h"

#include <cmath>
#include <vector>

namespace slipstick::test {
namespace {

using Maybe =
    std::optional<Dual>;  // every operation gives one; infinite ones are sorted out at the end

Dual chain(long double value, long double factor, const Dual& a) {
  return {value, factor * a.x, factor * a.y, factor * a.z};
}

Dual combined(long double value, long double p, const Dual& a, long double q, const Dual& b) {
  return {value, p * a.x + q * b.x, p * a.y + q * b.y, p * a.z + q * b.z};
}

Maybe unary(Op op, const Dual& a) {
  const long double v = a.value;
  switch (op) {
    case Op::kNegate:
      return chain(-v, -1, a);
    case Op::kAbs:
      return v > 0 ? a : chain(-v, -1, a);
    case Op::kSquare:
      return chain(v * v, 2 * v, a);
    case Op::kSqrt:
      return chain(std::sqrt(v), 0.5L / std::sqrt(v), a);
    case Op::kFloor:
      return chain(std::floor(v), 0, a);
    case Op::kCeil:
      return chain(std::ceil(v), 0, a);
    case Op::kRound:
      return chain(std::round(v), 0, a);
    case Op::kSin:
      return chain(std::sin(v), std::cos(v), a);
    case Op::kCos:
      return chain(std::cos(v), -std::sin(v), a);
    case Op::kTan:
      return chain(std::tan(v), 1 / (std::cos(v) * std::cos(v)), a);
    case Op::kAsin:
      return chain(std::asin(v), 1 / std::sqrt(1 - v * v), a);
    case Op::kAcos:
      return chain(std::acos(v), -1 / std::sqrt(1 - v * v), a);
    case Op::kAtan:
      return chain(std::atan(v), 1 / (1 + v * v), a);
    case Op::kExp:
      return chain(std::exp(v), std::exp(v), a);
    case Op::kLn:
      return chain(std::log(v), 1 / v, a);
    default:
      return chain(v == 0 ? 1 : 0, 0, a);
  }
}

Maybe remainder(const Dual& a, const Dual& b) {
  const long double size = std::abs(b.value), k = std::floor(a.value / size);
  return combined(a.value - k * size, 1, a, b.value < 0 ? k : -k, b);
}

Maybe binary(Op op, const Dual& a, const Dual& b) {
  const long double v = a.value, w = b.value, square = v * v + w * w;
  switch (op) {
    case Op::kAdd:
      return combined(v + w, 1, a, 1, b);
    case Op::kSubtract:
      return combined(v - w, 1, a, -1, b);
    case Op::kMultiply:
      return combined(v * w, w, a, v, b);
    case Op::kDivide:
      return combined(v / w, 1 / w, a, -v / (w * w), b);
    case Op::kMin:
      return v < w ? a : b;
    case Op::kMax:
      return v > w ? a : b;
    case Op::kAtan2:
      return combined(std::atan2(v, w), w / square, a, -v / square, b);
    case Op::kCompare:
      return Dual{v < w ? -1.0L : v > w ? 1.0L : 0.0L, 0, 0, 0};
    case Op::kModulo:
      return remainder(a, b);
    case Op::kAnd:
      return v == 0 ? a : b;
    default:
      return v == 0 ? b : a;
  }
}

Maybe leaf(const Graph::Node& node, Vec3 p) {
  switch (node.op) {
    case Op::kX:
      return Dual{p.x, 1, 0, 0};
    case Op::kY:
      return Dual{p.y, 0, 1, 0};
    case Op::kZ:
      return Dual{p.z, 0, 0, 1};
    default:
      return Dual{node.value, 0, 0, 0};
  }
}

bool finite(const Dual& d) {
  return std::isfinite(d.value) && std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z);
}

}  // namespace

std::optional<Dual> dual_of(const Graph& graph, Graph::Id root, Vec3 p) {
  std::vector<Maybe> duals(graph.size());
  for (const Graph::Id id : graph.order(root)) {
    const Graph::Node& n = graph[id];
    if (is_unary(n.op)) {
      duals[id] = unary(n.op, *duals[n.a]);
    } else if (is_binary(n.op)) {
      duals[id] = binary(n.op, *duals[n.a], *duals[n.b]);
    } else {
      duals[id] = leaf(n, p);
    }
    if (!finite(*duals[id])) return {};
  }
  return duals[root];
}

}  // namespace slipstick::test
