#include "core/expr/gradient.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "core/base/rng.h"
#include "tests/support/duals.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

constexpr Op kOps[] = {Op::kNegate,   Op::kAbs,    Op::kSquare,   Op::kSqrt,     Op::kFloor,
                       Op::kCeil,     Op::kRound,  Op::kSin,      Op::kCos,      Op::kTan,
                       Op::kAsin,     Op::kAcos,   Op::kAtan,     Op::kExp,      Op::kLn,
                       Op::kNot,      Op::kAdd,    Op::kSubtract, Op::kMin,      Op::kMax,
                       Op::kMultiply, Op::kDivide, Op::kAtan2,    Op::kCompare,  Op::kModulo,
                       Op::kAnd,      Op::kOr,     Op::kAdd,      Op::kMultiply, Op::kSubtract};

struct Expression {
  Graph graph;
  Graph::Id root = 0;
};

Expression random_expression(Rng& rng) {
  Expression e;
  std::vector<Graph::Id> nodes{e.graph.variable(Op::kX), e.graph.variable(Op::kY),
                               e.graph.variable(Op::kZ), e.graph.constant(rng.unit() * 4 - 2)};
  const std::size_t count = 1 + rng.below(12);
  for (std::size_t i = 0; i < count; ++i) {
    const Op op = kOps[rng.below(std::size(kOps))];
    const Graph::Id a = nodes[rng.below(nodes.size())], b = nodes[rng.below(nodes.size())];
    nodes.push_back(is_binary(op) ? e.graph.binary(op, a, b) : e.graph.unary(op, a));
  }
  e.root = nodes.back();
  return e;
}

Box3 random_box(Rng& rng) {
  const double size = std::pow(10, -5 * rng.unit());
  const Vec3 low{rng.unit() * 4 - 2, rng.unit() * 4 - 2, rng.unit() * 4 - 2};
  return {low, low + size * Vec3{rng.unit(), rng.unit(), rng.unit()}};
}

Vec3 point_in(const Box3& b, Rng& rng) {
  const auto between = [&](double low, double high) {
    return std::min(high, low + rng.unit() * (high - low));
  };
  return {between(b.low.x, b.high.x), between(b.low.y, b.high.y), between(b.low.z, b.high.z)};
}

// The oracle rounds where bounds may be exact: the slope of sqrt(x²) is 1.
bool holds(const Slope& s, long double v) {
  const long double rounding = 0x1p-55L * std::abs(v);
  return s.low <= v + rounding && v - rounding <= s.high;
}

void check_holds(const GradientRange& range, const Dual& d) {
  CAPTURE(range.value.low, range.value.high, static_cast<double>(d.value));
  CHECK(((range.value.may_be_nan || (range.value.low <= d.value && d.value <= range.value.high)) &&
         holds(range.x, d.x) && holds(range.y, d.y) && holds(range.z, d.z) &&
         holds(range.rising, d.x + d.y) && holds(range.falling, d.y - d.x)));
}

GradientRange range_of(const Graph& graph, Graph::Id root, const Box3& box) {
  return GradientEvaluator().over(compile(graph, root), box);
}

}  // namespace

TEST_CASE("Gradient intervals hold the gradient at every point of the box", "[gradient]") {
  Rng rng(4);
  int informative = 0;
  for (int round = 0; round < 5'000; ++round) {
    const Expression e = random_expression(rng);
    const Box3 box = random_box(rng);
    const GradientRange range = range_of(e.graph, e.root, box);
    for (int i = 0; i < 20; ++i) {
      const auto d = dual_of(e.graph, e.root, point_in(box, rng));
      if (!d) continue;
      CAPTURE(round, i);
      check_holds(range, *d);
      informative += range.x.known() ? 1 : 0;
    }
  }
  CHECK(informative > 30'000);
}

TEST_CASE("A crease holds the gradients of both sides", "[gradient]") {
  Graph g;
  const Graph::Id x = g.variable(Op::kX), y = g.variable(Op::kY);
  const Box3 box{{-1, -1, 0}, {1, 1, 1}};

  const GradientRange roof = range_of(g, g.unary(Op::kAbs, x), box);
  const GradientRange corner = range_of(g, g.binary(Op::kMax, x, y), box);

  CHECK((roof.x.low == -1 && roof.x.high == 1));
  CHECK((corner.x.low == 0 && corner.x.high == 1));
  // The sum of two intervals would be 0 to 2: the slope along the diagonal knows better.
  CHECK(corner.rising.low > 0.999);
}

TEST_CASE("A crease at the end of a box belongs to it", "[gradient]") {
  Graph g;
  const Graph::Id root = g.unary(Op::kAbs, g.variable(Op::kX));

  CHECK(range_of(g, root, {{0, 0, 0}, {1, 1, 1}}).x.low == -1);
  CHECK(range_of(g, root, {{-1, 0, 0}, {0, 1, 1}}).x.high == 1);
}

TEST_CASE("Upright walls have a slope in z of exactly nothing", "[gradient]") {
  Graph g;
  const Graph::Id x = g.variable(Op::kX), y = g.variable(Op::kY);
  const Graph::Id root =
      g.unary(Op::kSqrt, g.binary(Op::kAdd, g.unary(Op::kSquare, x), g.unary(Op::kSquare, y)));

  const GradientRange range = range_of(g, root, {{1, 1, 0}, {2, 2, 1}});

  CHECK((range.z.low == 0 && range.z.high == 0));
  CHECK(range.x.low > 0);
}

TEST_CASE("A jump in the box leaves nothing known", "[gradient]") {
  Graph g;
  const Graph::Id x = g.variable(Op::kX);
  const Box3 box{{0.5, 0, 0}, {1, 1, 1}};  // floor jumps where the box ends

  CHECK_FALSE(range_of(g, g.unary(Op::kFloor, x), box).x.known());
  CHECK_FALSE(range_of(g, g.binary(Op::kCompare, x, g.constant(1)), box).x.known());
  CHECK_FALSE(
      range_of(g, g.unary(Op::kSqrt, g.binary(Op::kSubtract, x, g.constant(0.5))), box).x.known());
}

TEST_CASE("The mean value form sees that a small box holds no surface", "[gradient]") {
  Graph g;  // x² - x + 1/4 + 1/1000: operation by operation it loses to itself
  const Graph::Id x = g.variable(Op::kX);
  const Graph::Id root =
      g.binary(Op::kAdd, g.binary(Op::kSubtract, g.unary(Op::kSquare, x), x), g.constant(0.251));
  const Box3 box{{0.49, 0, 0}, {0.51, 1, 1}};

  CHECK(prune(compile(g, root), box).range.low < 0);
  CHECK(range_of(g, root, box).no_surface());
}
