#include "core/solid/expr_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/check.h"
#include "core/expr/block.h"
#include "core/expr/extent.h"
#include "core/expr/tape.h"
#include "core/solid/expr_painter.h"

namespace slipstick {
namespace {

// What a section and those narrowed from it share; all of them are used by one thread.
struct Shared {
  explicit Shared(const Tape& tape) : program(tape) {}

  Program program;
  BlockRegisters registers;
  Specializer specializer;
  BoxNotes notes;
  std::vector<Instruction> room;
};

class ExprSection final : public Section {
 public:
  explicit ExprSection(std::shared_ptr<Shared> shared)
      : shared_(std::move(shared)), listing_(shared_->program.listing()) {}

  // The same in a box, for fewer instructions.
  ExprSection(std::shared_ptr<Shared> shared, const Listing& listing)
      : shared_(std::move(shared)),
        instructions_(listing.instructions.begin(), listing.instructions.end()),
        listing_{instructions_, listing.result, listing.registers} {}

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override {
    in_blocks(xs, ys, [&](std::size_t at, double value) {
      inside[at] = value <= 0 ? 1 : 0;
      if (std::isnan(value) && !undefined_) undefined_ = {xs[at], ys[at]};
    });
  }

  bool evaluate(std::span<const double> xs, std::span<const double> ys,
                std::span<double> values) override {
    in_blocks(xs, ys, [&](std::size_t at, double value) { values[at] = value; });
    return true;
  }

  bool paint(BitImage& image) override {
    SLIPSTICK_CHECK(instructions_.empty());  // a narrowed section knows one box only
    ExprPainter painter(shared_->program, shared_->registers, image);
    painter.paint();
    undefined_ = painter.undefined_at();
    return true;
  }

  [[nodiscard]] Narrowed narrowed(const Box2& box) override {
    Shared& s = *shared_;
    const std::size_t length = listing_.instructions.size();
    if (s.room.size() < length) s.room.resize(length);
    const BoxBatch boxes{{box.low.x}, {box.high.x}, {box.low.y}, {box.high.y}, 1};
    const BoxVerdict verdict = bound(listing_, s.program, boxes, s.registers, s.notes);
    if (verdict.at_most_zero != 0) return {Cover::kInside, nullptr};
    if (verdict.above_zero != 0) return {Cover::kOutside, nullptr};
    const Listing inner = s.specializer.specialize(listing_, s.notes, 0, Demand::kValue, s.room);
    if (inner.instructions.size() == length || inner.instructions.empty()) return {};
    return {Cover::kMixed, std::make_unique<ExprSection>(shared_, inner)};
  }

  [[nodiscard]] std::optional<Vec2> undefined_at() const override { return undefined_; }

 private:
  template <typename F>
  void in_blocks(std::span<const double> xs, std::span<const double> ys, F f) {
    for (std::size_t first = 0; first < xs.size(); first += kBlockPoints) {
      const std::size_t count = std::min(kBlockPoints, xs.size() - first);
      const auto values = slipstick::evaluate(listing_, shared_->program, xs.subspan(first, count),
                                              ys.subspan(first, count), shared_->registers);
      for (std::size_t i = 0; i < count; ++i) f(first + i, values[i]);
    }
  }

  std::shared_ptr<Shared> shared_;
  std::vector<Instruction> instructions_;
  Listing listing_;
  std::optional<Vec2> undefined_;
};

class ExprField final : public Field {
 public:
  explicit ExprField(Tape tape) : tape_(std::move(tape)) {}

  [[nodiscard]] GradientRange over(const Box3& box) override { return evaluator_.over(tape_, box); }
  [[nodiscard]] std::unique_ptr<Field> narrowed(const Box3& box) override {
    Pruned pruned = prune(tape_, box);
    if (pruned.tape.steps.empty()) return nullptr;
    return std::make_unique<ExprField>(std::move(pruned.tape));
  }

 private:
  Tape tape_;
  GradientEvaluator evaluator_;
};

class ExprSolid final : public Solid {
 public:
  ExprSolid(Tape tape, const Box3& bounds) : tape_(std::move(tape)), bounds_(bounds) {}

  [[nodiscard]] Box3 bounds() const override { return bounds_; }
  [[nodiscard]] std::unique_ptr<Section> section(double z) const override {
    return std::make_unique<ExprSection>(std::make_shared<Shared>(at_height(tape_, z)));
  }
  [[nodiscard]] std::unique_ptr<Field> field() const override {
    return std::make_unique<ExprField>(tape_);
  }

 private:
  Tape tape_;
  Box3 bounds_;
};

// f of the box itself: positive outside it.
Graph::Id box_of(Graph& graph, const Box3& box) {
  const auto side = [&](Op axis, double low, double high) {
    const Graph::Id v = graph.variable(axis);
    return graph.binary(Op::kMax, graph.binary(Op::kSubtract, graph.constant(low), v),
                        graph.binary(Op::kSubtract, v, graph.constant(high)));
  };
  const Graph::Id xy = graph.binary(Op::kMax, side(Op::kX, box.low.x, box.high.x),
                                    side(Op::kY, box.low.y, box.high.y));
  return graph.binary(Op::kMax, xy, side(Op::kZ, box.low.z, box.high.z));
}

}  // namespace

ExprModel::ExprModel(Graph graph, Graph::Id root, const Box3& bounds)
    : graph_(std::move(graph)), root_(root), bounds_(bounds) {
  SLIPSTICK_CHECK(!bounds.empty() && std::isfinite(length(bounds.size())));
  root_ = graph_.binary(Op::kMax, root_, box_of(graph_, bounds));
}

ExprModel::Mapped ExprModel::mapped(const Affine3& map) const {
  Graph graph = graph_;
  const Graph::Id root = graph.mapped(root_, inverse(map));
  return {std::move(graph), root};
}

Box3 ExprModel::bounds_under(const Affine3& map) const {
  const Mapped m = mapped(map);
  return extent(compile(m.graph, m.root), image_of(map, bounds_));
}

std::shared_ptr<const Solid> ExprModel::placed(const Affine3& map) const {
  const Mapped m = mapped(map);
  return std::make_shared<ExprSolid>(compile(m.graph, m.root), image_of(map, bounds_));
}

std::string ExprModel::size_text() const {
  return fmt::format("{} operations", graph_.order(root_).size());
}

}  // namespace slipstick
