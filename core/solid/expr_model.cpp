#include "core/solid/expr_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/expr/extent.h"
#include "core/expr/tape.h"

namespace slipstick {
namespace {

class ExprSection final : public Section {
 public:
  ExprSection(std::shared_ptr<const Tape> tape, double z) : tape_(std::move(tape)), z_(z) {}

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override {
    for (std::size_t first = 0; first < xs.size(); first += TapeEvaluator::kPointsMax) {
      const std::size_t count = std::min(TapeEvaluator::kPointsMax, xs.size() - first);
      const auto values =
          evaluator_.evaluate(*tape_, xs.subspan(first, count), ys.subspan(first, count), z_);
      for (std::size_t i = 0; i < count; ++i) {
        inside[first + i] = values[i] <= 0 ? 1 : 0;
        if (std::isnan(values[i]) && !undefined_) undefined_ = {xs[first + i], ys[first + i]};
      }
    }
  }

  [[nodiscard]] Narrowed narrowed(const Box2& box) override {
    Pruned pruned = prune(*tape_, {{box.low.x, box.low.y, z_}, {box.high.x, box.high.y, z_}});
    if (!pruned.range.may_be_nan) {
      if (pruned.range.high <= 0) return {Cover::kInside, nullptr};
      if (pruned.range.low > 0) return {Cover::kOutside, nullptr};
    }
    if (pruned.tape.steps.empty()) return {};
    return {Cover::kMixed, std::make_unique<ExprSection>(
                               std::make_shared<const Tape>(std::move(pruned.tape)), z_)};
  }

  [[nodiscard]] std::optional<Vec2> undefined_at() const override { return undefined_; }

 private:
  std::shared_ptr<const Tape> tape_;
  double z_;
  std::optional<Vec2> undefined_;
  TapeEvaluator evaluator_;
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
  ExprSolid(Graph graph, Graph::Id root, const Box3& bounds)
      : graph_(std::move(graph)), root_(root), bounds_(bounds) {}

  [[nodiscard]] Box3 bounds() const override { return bounds_; }
  [[nodiscard]] std::unique_ptr<Section> section(double z) const override {
    return std::make_unique<ExprSection>(std::make_shared<const Tape>(compile_at(graph_, root_, z)),
                                         z);
  }
  [[nodiscard]] std::unique_ptr<Field> field() const override {
    return std::make_unique<ExprField>(compile(graph_, root_));
  }

 private:
  Graph graph_;
  Graph::Id root_;
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
  Mapped m = mapped(map);
  const Box3 bounds = image_of(map, bounds_);
  return std::make_shared<ExprSolid>(std::move(m.graph), m.root, bounds);
}

std::string ExprModel::size_text() const {
  return fmt::format("{} operations", graph_.order(root_).size());
}

}  // namespace slipstick
