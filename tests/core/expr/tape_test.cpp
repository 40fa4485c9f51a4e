#include "core/expr/tape.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/expr/extent.h"
#include "tests/support/expression_bytes.h"

using namespace slipstick;

namespace {

constexpr Op kOps[] = {
    Op::kNegate, Op::kAbs,   Op::kSquare,  Op::kSqrt,     Op::kFloor,    Op::kCeil,   Op::kRound,
    Op::kSin,    Op::kCos,   Op::kTan,     Op::kAsin,     Op::kAcos,     Op::kAtan,   Op::kExp,
    Op::kLn,     Op::kNot,   Op::kAdd,     Op::kSubtract, Op::kMultiply, Op::kDivide, Op::kMin,
    Op::kMax,    Op::kAtan2, Op::kCompare, Op::kModulo,   Op::kAnd,      Op::kOr};

Graph::Id random_expression(Graph& graph, Rng& rng) {
  std::vector<Graph::Id> nodes{graph.variable(Op::kX), graph.variable(Op::kY),
                               graph.variable(Op::kZ), graph.constant(rng.unit() * 2 - 1)};
  for (int i = 0; i < 20; ++i) {
    // Mostly min and max, so that there is something to prune.
    const Op op = rng.below(2) == 0 ? (rng.below(2) == 0 ? Op::kMin : Op::kMax)
                                    : kOps[rng.below(std::size(kOps))];
    const Graph::Id a = nodes[rng.below(nodes.size())], b = nodes[rng.below(nodes.size())];
    nodes.push_back(is_binary(op) ? graph.binary(op, a, b) : graph.unary(op, a));
  }
  return nodes.back();
}

double value_at(const Tape& tape, Vec3 p) {
  TapeEvaluator evaluator;
  return evaluator.evaluate(tape, {&p.x, 1}, {&p.y, 1}, p.z)[0];
}

}  // namespace

TEST_CASE("Tapes, pruned tapes and intervals agree with the definition, bit for bit") {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Rng rng(seed);
    Graph graph;
    const Graph::Id root = random_expression(graph, rng);
    const Tape tape = compile(graph, root);
    const double size = std::pow(0.5, static_cast<double>(rng.below(8)));
    const Vec3 low{rng.unit() * 4 - 2, rng.unit() * 4 - 2, rng.unit() * 4 - 2};
    const Pruned pruned = prune(tape, {low, low + Vec3{size, size, size}});
    INFO("seed " << seed);
    for (int i = 0; i < 5; ++i) {
      const Vec3 p = low + size * Vec3{rng.unit(), rng.unit(), rng.unit()};

      const double value = value_at(tape, p);

      REQUIRE(test::same_value(value, test::value_of(graph, root, p)));
      REQUIRE(test::same_value(value, value_at(at_height(compile(graph, root), p.z), p)));
      if (!pruned.tape.steps.empty()) REQUIRE(test::same_value(value, value_at(pruned.tape, p)));
      if (std::isnan(value)) {
        REQUIRE(pruned.range.may_be_nan);
      } else {
        REQUIRE(value >= pruned.range.low);
        REQUIRE(value <= pruned.range.high);
      }
    }
  }
}

TEST_CASE("Intervals hold what operations give, for spicy operands too") {
  const double spicy[] = {0.0,
                          -0.0,
                          1,
                          -1,
                          0.5,
                          1e-310,
                          -1e-310,
                          1e300,
                          -1e300,
                          3.141592653589793,
                          -2.5,
                          7,
                          std::numeric_limits<double>::infinity()};
  for (const Op op : kOps) {
    for (const double a : spicy) {
      for (const double b : spicy) {
        for (const double c : {a, b, -b}) {
          const Interval x = Interval::of(std::min(a, c), std::max(a, c));
          const Interval result = apply(op, x, Interval::of(b, b));
          const double value = apply(op, a, b);
          INFO(static_cast<int>(op) << " of " << a << " and " << b);
          if (std::isnan(value)) {
            CHECK(result.may_be_nan);
          } else {
            CHECK(value >= result.low);
            CHECK(value <= result.high);
          }
        }
      }
    }
  }
}

TEST_CASE("The extent of a ball is tight, that of nothing is empty") {
  Graph graph;
  const auto square = [&](Op v) { return graph.unary(Op::kSquare, graph.variable(v)); };
  const Graph::Id sum = graph.binary(
      Op::kAdd, graph.binary(Op::kAdd, square(Op::kX), square(Op::kY)), square(Op::kZ));
  const auto ball = [&](double radius) {
    const Graph::Id f =
        graph.binary(Op::kSubtract, graph.unary(Op::kSqrt, sum), graph.constant(radius));
    return extent(compile(graph, f), {{-10, -10, -10}, {10, 10, 10}});
  };

  CHECK(ball(3).low.z == Approx(-3).margin(0.011));
  CHECK(ball(3).low.z <= -3);
  CHECK(ball(3).high.x == Approx(3).margin(0.09));
  CHECK(ball(-1).empty());
}
