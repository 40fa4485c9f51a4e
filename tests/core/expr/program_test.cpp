// Programs give the bits of the operations, however they are shortened for a box or run over a
// tile.
#include "core/expr/program.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/expr/block.h"
#include "core/expr/row_spans.h"
#include "tests/support/expression_bytes.h"

using namespace slipstick;

namespace {

constexpr int kExpressions = 4000;

// Any expression of some 20 operations.
test::ByteExpression random_expression(std::uint64_t seed) {
  Rng rng(seed);
  std::vector<std::uint8_t> bytes(60);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng.below(256));
  return test::expression_of(bytes);
}

Program program_of(const test::ByteExpression& e) {
  return Program(at_height(compile(e.graph, e.root), e.box.low.z));
}

// A grid of points of a box, its corners included.
struct Points {
  explicit Points(const Box3& box) {
    for (int i = 0; i < 36; ++i) {
      xs.push_back(box.low.x + box.size().x * (i % 6) / 5);
      ys.push_back(box.low.y + box.size().y * (i / 6) / 5);
    }
  }
  std::vector<double> xs, ys;
};

bool same_values(std::span<const double> a, std::span<const double> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), test::same_value);
}

}  // namespace

TEST_CASE("A program shortened for a box gives the same bits there, whole numbers included") {
  int shorter = 0;
  for (std::uint64_t seed = 0; seed < kExpressions; ++seed) {
    const test::ByteExpression e = random_expression(seed);
    const Program program = program_of(e);
    const Box3& box = e.box;
    const Points points(box);
    BlockRegisters registers;
    BoxNotes notes;
    const BoxBatch boxes{{box.low.x}, {box.high.x}, {box.low.y}, {box.high.y}, 1};
    std::vector<Instruction> room(program.listing().instructions.size());

    static_cast<void>(bound(program.listing(), program, boxes, registers, notes));
    const Listing inner =
        Specializer().specialize(program.listing(), notes, 0, Demand::kValue, room);

    const auto found = evaluate(inner, program, points.xs, points.ys, registers);
    const std::vector<double> values(found.begin(), found.end());
    INFO("seed " << seed);
    REQUIRE(
        same_values(values, evaluate(program.listing(), program, points.xs, points.ys, registers)));
    if (inner.instructions.size() < room.size()) ++shorter;
  }
  CHECK(shorter > kExpressions / 20);
}

TEST_CASE("A program over a tile gives the bits that it gives point by point") {
  for (std::uint64_t seed = 0; seed < kExpressions; ++seed) {
    const test::ByteExpression e = random_expression(seed);
    const Program program = program_of(e);
    const Listing listing = program.listing();
    BlockRegisters of_tile, of_points;
    double* const values = of_tile.prepare(listing.registers, kBlockPoints);
    std::vector<double> xs, ys;
    for (std::size_t i = 0; i < kTileSide; ++i) {
      values[i] = e.box.low.x + 0.1 * static_cast<double>(i);
      values[kBlockPoints + i] = e.box.low.y + 0.1 * static_cast<double>(i);
    }
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
      xs.push_back(values[i % kTileSide]);
      ys.push_back(values[kBlockPoints + i / kTileSide]);
    }
    std::vector<TileRegister> states(listing.registers);
    states[kRegisterX] = {true, false, false};
    states[kRegisterY] = {false, true, false};

    run_tile(
        {listing.instructions, program.constants().data(), values, states.data(), listing.result});

    INFO("seed " << seed);
    REQUIRE(same_values({values + listing.result * kBlockPoints, kBlockPoints},
                        evaluate(listing, program, xs, ys, of_points)));
  }
}

TEST_CASE("Within one cell of what is repeated the repetition is a constant") {
  Graph graph;
  const Graph::Id x = graph.variable(Op::kX), y = graph.variable(Op::kY);
  const auto with = [&](Op op, Graph::Id a, double c) {
    return graph.binary(op, a, graph.constant(c));
  };
  const Graph::Id cell = with(Op::kMultiply, graph.unary(Op::kFloor, with(Op::kDivide, x, 7)), 7);
  const Graph::Id disc =
      with(Op::kSubtract,
           graph.binary(Op::kAdd, graph.unary(Op::kSquare, graph.binary(Op::kSubtract, x, cell)),
                        graph.unary(Op::kSquare, y)),
           4);
  const Program program(at_height(compile(graph, disc), 0));
  BlockRegisters registers;
  BoxNotes notes;
  std::vector<Instruction> room(program.listing().instructions.size());
  const auto lowers = [&](double low, double high) {
    const BoxBatch boxes{{low}, {high}, {-1}, {1}, 1};
    static_cast<void>(bound(program.listing(), program, boxes, registers, notes));
    return RowSpans().lower(
        Specializer().specialize(program.listing(), notes, 0, Demand::kSign, room),
        program.constants());
  };

  CHECK(lowers(14.5, 20.5));
  CHECK(lowers(0, 6.5));
  CHECK_FALSE(lowers(13.5, 14.5));
}
