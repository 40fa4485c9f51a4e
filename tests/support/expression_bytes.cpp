#include "tests/support/expression_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "core/base/check.h"
#include "core/expr/tape.h"
#include "core/image/sample.h"
#include "core/solid/expr_model.h"

namespace slipstick::test {
namespace {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t next() { return done() ? std::uint8_t{0} : bytes_[at_++]; }
  [[nodiscard]] bool done() const { return at_ >= bytes_.size(); }

  double any_double() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | next();
    return std::bit_cast<double>(bits);
  }
  // A multiple of 1/16 between -8 and 8.
  double small() { return (next() - 128) / 16.0; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

constexpr int kOpCount = static_cast<int>(Op::kOr) + 1;

Graph::Id next_step(Graph& graph, Bytes& bytes, const std::vector<Graph::Id>& known) {
  const auto op = static_cast<Op>(bytes.next() % kOpCount);
  const auto operand = [&] { return known[known.size() - 1 - bytes.next() % known.size()]; };
  if (op == Op::kConstant) {
    return graph.constant(bytes.next() % 4 == 0 ? bytes.any_double() : bytes.small());
  }
  if (op == Op::kX || op == Op::kY || op == Op::kZ) return graph.variable(op);
  const Graph::Id a = operand();
  return is_binary(op) ? graph.binary(op, a, operand()) : graph.unary(op, a);
}

Vec3 at(const Box3& box, double x, double y) {
  return {box.low.x + x * box.size().x, box.low.y + y * box.size().y, box.low.z};
}

// A plane box is a box, too: what is printed is a plane.
void check_intervals(const ByteExpression& e, const Tape& tape, const Box3& box) {
  const Pruned pruned = prune(tape, box);
  constexpr std::array<double, 4> kParts{0, 0.375, 0.8125, 1};
  for (const double part_x : kParts) {
    for (const double part_y : kParts) {
      const Vec3 p = at(box, part_x, part_y);
      const double value = value_of(e.graph, e.root, p);
      TapeEvaluator evaluator;
      const Tape& shorter = pruned.tape.steps.empty() ? tape : pruned.tape;
      SLIPSTICK_CHECK(same_value(value, evaluator.evaluate(shorter, {&p.x, 1}, {&p.y, 1}, p.z)[0]));
      SLIPSTICK_CHECK(std::isnan(value) ? pruned.range.may_be_nan
                                        : value >= pruned.range.low && value <= pruned.range.high);
    }
  }
}

void check_image(const ByteExpression& e, double z) {
  const auto solid = ExprModel(e.graph, e.root, e.box).placed(Affine3{});
  const auto section = solid->section(z);
  const auto grid =
      SliceGrid::over({{e.box.low.x, e.box.low.y}, {e.box.high.x, e.box.high.y}}, e.sampling);
  SLIPSTICK_CHECK(grid.has_value());
  const auto image = sample(*section, *grid);
  bool undefined = false;
  for (int row = 1; row < grid->rows() - 1; ++row) {
    for (int column = 1; column < grid->columns() - 1; ++column) {
      const Vec3 p{grid->node_x(column), grid->node_y(row), z};
      const double value = value_of(e.graph, e.root, p);
      undefined |= std::isnan(value);
      const bool in_box = p.x >= e.box.low.x && p.x <= e.box.high.x && p.y >= e.box.low.y &&
                          p.y <= e.box.high.y && z >= e.box.low.z && z <= e.box.high.z;
      if (image) SLIPSTICK_CHECK(image->at(column, row) == (in_box && value <= 0));
    }
  }
  SLIPSTICK_CHECK(image.has_value() == !undefined);
}

}  // namespace

ByteExpression expression_of(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  ByteExpression e;
  e.box.low = {bytes.small(), bytes.small(), bytes.small()};
  const double size = std::exp2(bytes.next() % 8 - 3);  // mm
  e.box.high = e.box.low + Vec3{size, size / (1 + bytes.next() % 3), size};
  e.sampling =
      std::clamp(size / (2 + bytes.next() % 80), SliceGrid::kWidthMin, SliceGrid::kWidthMax);
  std::vector<Graph::Id> known{e.graph.variable(Op::kX), e.graph.variable(Op::kY)};
  for (int i = 0; i < kByteStepsMax && !bytes.done(); ++i) {
    known.push_back(next_step(e.graph, bytes, known));
  }
  e.root = known.back();
  return e;
}

double value_of(const Graph& graph, Graph::Id root, Vec3 p) {
  std::vector<double> values(root + 1);
  for (const Graph::Id id : graph.order(root)) {
    const Graph::Node& node = graph[id];
    const std::array<double, 4> leaves{node.value, p.x, p.y, p.z};
    values[id] = is_unary(node.op) || is_binary(node.op)
                     ? apply(node.op, values[node.a], values[node.b])
                     : leaves[static_cast<std::size_t>(node.op)];
  }
  return values[root];
}

bool same_value(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

void check_against_oracle(const ByteExpression& e) {
  const Tape tape = compile(e.graph, e.root);
  check_intervals(e, tape, e.box);
  Box3 plane = e.box;
  plane.high.z = plane.low.z;
  check_intervals(e, tape, plane);
  check_image(e, e.box.low.z);
}

}  // namespace slipstick::test
