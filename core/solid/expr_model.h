#pragma once

#include "core/expr/graph.h"
#include "core/solid/solid.h"

namespace slipstick {

/// The solid {f <= 0} of an expression, within a box in its own frame.
class ExprModel final : public Model {
 public:
  /// \pre `bounds` is finite and not empty; nothing of the solid that counts lies outside it.
  ExprModel(Graph graph, Graph::Id root, const Box3& bounds);

  [[nodiscard]] Box3 bounds_under(const Affine3& map) const override;
  [[nodiscard]] std::shared_ptr<const Solid> placed(const Affine3& map) const override;
  [[nodiscard]] std::string_view kind() const override { return "expression"; }
  [[nodiscard]] std::string size_text() const override;

 private:
  // The expression seen from the frame that `map` leads to, cut off at the bounds.
  struct Mapped {
    Graph graph;
    Graph::Id root;
  };
  [[nodiscard]] Mapped mapped(const Affine3& map) const;

  Graph graph_;
  Graph::Id root_;
  Box3 bounds_;
};

}  // namespace slipstick
