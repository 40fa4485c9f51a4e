// What is drawn by spans of rows has the signs that the arithmetic gives, and little is left in
// doubt.
#include "core/expr/row_spans.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/expr/tape.h"
#include "core/image/sample.h"
#include "core/solid/expr_model.h"
#include "tests/support/expression_bytes.h"

using namespace slipstick;

namespace {

constexpr double kWidth = 0.25;  // exact, so that solids can lie on nodes
constexpr int kSide = static_cast<int>(kSpanTile);

// Places and sizes on nodes, or anywhere, or anywhere but so that the rim is a rounding from a
// node.
enum class Lie { kOnNodes, kAnywhere, kByNodes };

// Solids made of chains.
class Shapes {
 public:
  Shapes(Graph& graph, Rng& rng, Lie lie)
      : graph_(graph), rng_(rng), lie_(lie), on_nodes_(lie == Lie::kOnNodes) {}

  Graph::Id any(int depth) {
    if (depth == 0) return simple();
    const Graph::Id a = any(depth - 1), b = any(depth - 1);
    const Graph::Id least = graph_.constant(std::numeric_limits<double>::denorm_min());
    switch (rng_.below(3)) {
      case 0:
        return graph_.binary(Op::kMin, a, b);
      case 1:
        return graph_.binary(Op::kMax, a, b);
      default:  // a without b: what is zero of b is left out
        return graph_.binary(Op::kMax, a,
                             graph_.binary(Op::kAdd, graph_.unary(Op::kNegate, b), least));
    }
  }

  Graph::Id simple() {
    if (lie_ == Lie::kByNodes) return by_node();
    switch (rng_.below(6)) {
      case 0:
        return half_plane();
      case 1:
        return less(round(), length());
      case 2:  // a shell
        return less(graph_.unary(Op::kAbs, less(round(), length())), length() / 8);
      case 3:
        return box();
      case 4:  // without a root
        return less(squares(), length() * length());
      default:
        return graph_.binary(Op::kSubtract, graph_.constant(length()), round());
    }
  }

 private:
  double place() {
    return on_nodes_ ? kWidth * static_cast<double>(rng_.below(64)) : 16 * rng_.unit();
  }
  double length() { return place() / 2; }
  Graph::Id less(Graph::Id a, double c) {
    return graph_.binary(Op::kSubtract, a, graph_.constant(c));
  }
  Graph::Id from(Op axis) { return less(graph_.variable(axis), place()); }
  Graph::Id squares() {
    return graph_.binary(Op::kAdd, graph_.unary(Op::kSquare, from(Op::kX)),
                         graph_.unary(Op::kSquare, from(Op::kY)));
  }
  Graph::Id round() { return graph_.unary(Op::kSqrt, squares()); }
  Graph::Id half_plane() {
    const double sign = rng_.below(2) == 0 ? 1.0 : -1.0;
    const double slope =
        sign * (on_nodes_ ? 1 + static_cast<double>(rng_.below(2)) : 2 * rng_.unit());
    return graph_.binary(
        Op::kAdd, graph_.binary(Op::kMultiply, from(Op::kX), graph_.constant(slope)), from(Op::kY));
  }
  // What is zero at some node, but for its last bit.
  Graph::Id by_node() {
    const Graph::Id shape = rng_.below(3) == 0   ? half_plane()
                            : rng_.below(2) == 0 ? round()
                                                 : squares();
    const auto node = [this] { return kWidth * static_cast<double>(rng_.below(64)); };
    const double value = test::value_of(graph_, shape, {node(), node(), 0});
    const double towards[] = {-1e9, value, 1e9};
    return less(shape, std::nextafter(value, towards[rng_.below(3)]));
  }
  Graph::Id box() {
    return graph_.binary(Op::kMax, less(graph_.unary(Op::kAbs, from(Op::kX)), length()),
                         less(graph_.unary(Op::kAbs, from(Op::kY)), length()));
  }

  Graph& graph_;
  Rng& rng_;
  Lie lie_;
  bool on_nodes_;
};

struct Drawn {
  int wrong = 0;
  int doubtful = 0;
};

// Node by node against the instructions.
Drawn compare(const Program& program, std::int64_t first_column) {
  RowSpans spans;
  REQUIRE(spans.lower(program.listing(), program.constants()));
  SpanTile tile{first_column, kWidth, {}};
  for (int row = 0; row < kSide; ++row) tile.ys[static_cast<std::size_t>(row)] = kWidth * row;
  BlockRegisters drawing, asking;
  const RowWords& words = spans.draw(tile, drawing);
  std::array<double, kSpanTile> xs{}, ys{};
  for (int i = 0; i < kSide; ++i) {
    xs[static_cast<std::size_t>(i)] = kWidth * static_cast<double>(first_column + i);
  }
  Drawn result;
  for (std::size_t row = 0; row < kSpanTile; ++row) {
    ys.fill(tile.ys[row]);
    const auto values = evaluate(program.listing(), program, xs, ys, asking);
    std::uint64_t truth = 0;
    for (std::size_t i = 0; i < kSpanTile; ++i) truth |= std::uint64_t{values[i] <= 0} << i;
    result.wrong += std::popcount((words.surely[row] & ~truth) | (truth & ~words.maybe[row]));
    result.doubtful += std::popcount(words.maybe[row] & ~words.surely[row]);
  }
  return result;
}

// How many nodes of an image of several tiles have not the sign of the arithmetic.
int wrong_nodes(const Graph& graph, Graph::Id root) {
  const Tape tape = compile(graph, root);
  const auto grid = SliceGrid::over({{-10, -10}, {26, 26}}, kWidth);
  REQUIRE(grid.has_value());
  const ExprModel model(graph, root, {{-10, -10, -1}, {26, 26, 1}});
  const auto image = sample(*model.placed({})->section(0), *grid);
  REQUIRE(image.has_value());
  TapeEvaluator evaluator;
  int wrong = 0;
  for (int row = 3; row < grid->rows() - 3; ++row) {
    for (int column = 3; column < grid->columns() - 3; ++column) {
      const double x = grid->node_x(column), y = grid->node_y(row);
      const bool inside = evaluator.evaluate(tape, {&x, 1}, {&y, 1}, 0)[0] <= 0;
      wrong += image->at(column, row) == inside ? 0 : 1;
    }
  }
  return wrong;
}

}  // namespace

TEST_CASE("Row spans have the signs of the arithmetic, at nodes that are zero or nearly so, too") {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Rng rng(seed);
    Graph graph;
    const Lie lie = std::array{Lie::kOnNodes, Lie::kAnywhere, Lie::kByNodes}[seed % 3];
    const Graph::Id root = Shapes(graph, rng, lie).any(static_cast<int>(rng.below(4)));
    INFO("seed " << seed);

    const Drawn drawn = compare(Program(at_height(compile(graph, root), 0)),
                                static_cast<std::int64_t>(rng.below(40)) - 20);

    REQUIRE(drawn.wrong == 0);
    if (lie == Lie::kAnywhere) REQUIRE(drawn.doubtful == 0);
  }
}

TEST_CASE("Where a disc has nodes on its rim, just those are in doubt") {
  Graph graph;
  const auto square_from = [&](Op axis, double at) {
    return graph.unary(Op::kSquare,
                       graph.binary(Op::kSubtract, graph.variable(axis), graph.constant(at)));
  };
  const Graph::Id disc = graph.binary(
      Op::kSubtract,
      graph.unary(Op::kSqrt,
                  graph.binary(Op::kAdd, square_from(Op::kX, 8), square_from(Op::kY, 8))),
      graph.constant(5));

  const Drawn drawn = compare(Program(at_height(compile(graph, disc), 0)), 0);

  // Of radius 20 cells: (20, 0), (16, 12), (12, 16) and their mirror images; where the rim touches
  // the row, it may be anywhere in it.
  CHECK(drawn.wrong == 0);
  CHECK(drawn.doubtful == 2 + 8 + 2 * kSide);
}

TEST_CASE("What is no chain by min and max is not drawn by spans") {
  Graph graph;
  const Graph::Id x = graph.variable(Op::kX), y = graph.variable(Op::kY);
  const Graph::Id one = graph.constant(1);
  const Graph::Id turned = graph.unary(Op::kSquare, graph.binary(Op::kAdd, x, y));
  const Graph::Id across = graph.unary(Op::kSquare, graph.binary(Op::kSubtract, x, y));
  const Graph::Id chosen = graph.binary(Op::kMax, x, one);
  for (const Graph::Id root :
       {graph.unary(Op::kSin, x), graph.binary(Op::kMultiply, x, y),
        graph.binary(Op::kAdd, turned, across), graph.unary(Op::kSquare, chosen),
        graph.binary(Op::kMin, graph.binary(Op::kDivide, one, x), y),
        graph.binary(Op::kMultiply, x, graph.constant(1e-200)),
        graph.unary(
            Op::kAbs,
            graph.unary(
                Op::kAbs,
                graph.binary(Op::kSubtract,
                             graph.unary(Op::kAbs, graph.binary(Op::kSubtract,
                                                                graph.unary(Op::kAbs, x), one)),
                             one)))}) {
    const Program program(at_height(compile(graph, root), 0));
    CHECK_FALSE(RowSpans().lower(program.listing(), program.constants()));
  }
}

TEST_CASE("Images of solids on the lattice are those of the arithmetic, tile by tile") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    Graph graph;
    const Graph::Id root = Shapes(graph, rng, seed % 2 == 0 ? Lie::kOnNodes : Lie::kByNodes).any(5);
    INFO("seed " << seed);
    CHECK(wrong_nodes(graph, root) == 0);
  }
}
