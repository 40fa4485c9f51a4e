#include "tests/support/solids.h"

#include <cmath>

namespace slipstick::test {
namespace {

class BallSection final : public Section {
 public:
  BallSection(const Affine3& to_model, double radius, double z)
      : to_model_(to_model), radius_(radius), z_(z) {}

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override {
    for (std::size_t i = 0; i < xs.size(); ++i) {
      inside[i] = length(to_model_({xs[i], ys[i], z_})) <= radius_ ? 1 : 0;
    }
  }
  Narrowed narrowed(const Box2&) override { return {}; }

 private:
  Affine3 to_model_;
  double radius_;
  double z_;
};

class Ball final : public Solid {
 public:
  Ball(const Affine3& map, double radius, const Box3& bounds)
      : to_model_(inverse(map)), radius_(radius), bounds_(bounds) {}

  [[nodiscard]] Box3 bounds() const override { return bounds_; }
  [[nodiscard]] std::unique_ptr<Section> section(double z) const override {
    return std::make_unique<BallSection>(to_model_, radius_, z);
  }

 private:
  Affine3 to_model_;
  double radius_;
  Box3 bounds_;
};

}  // namespace

// The extent of an ellipsoid along an axis is the length of that row of the map.
Box3 BallModel::bounds_under(const Affine3& map) const {
  const auto reach = [&](std::size_t i) {
    const auto& r = map.rows[i];
    return radius_ * std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  };
  const Vec3 centre = map({0, 0, 0}), half{reach(0), reach(1), reach(2)};
  return {centre - half, centre + half};
}

std::shared_ptr<const Solid> BallModel::placed(const Affine3& map) const {
  return std::make_shared<Ball>(map, radius_, bounds_under(map));
}

}  // namespace slipstick::test
