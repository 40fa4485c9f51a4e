#pragma once

#include <memory>

#include "core/solid/solid.h"

namespace slipstick::test {

/// A ball about the origin, computed the slow and obvious way: no box of it is ever known as a
/// whole.
class BallModel final : public Model {
 public:
  explicit BallModel(double radius) : radius_(radius) {}

  [[nodiscard]] Box3 bounds_under(const Affine3& map) const override;
  [[nodiscard]] std::shared_ptr<const Solid> placed(const Affine3& map) const override;
  [[nodiscard]] std::string_view kind() const override { return "ball"; }
  [[nodiscard]] std::string size_text() const override { return "1 ball"; }

 private:
  double radius_;
};

}  // namespace slipstick::test
