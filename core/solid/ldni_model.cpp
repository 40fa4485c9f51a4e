#include "core/solid/ldni_model.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "core/solid/ldni_section.h"

namespace slipstick {
namespace {

// How far from the solid a point inside can be, in widths.
const double kOff = std::sqrt(2 + kLdniShiftMax * kLdniShiftMax);

Affine3 to_widths(const LdniGrid& grid) {
  const double share = 1 / grid.width();
  const Vec3 o = grid.origin();
  return composed(scaling({share, share, share}), translation({-o.x, -o.y, -o.z}));
}

class LdniSolid final : public Solid {
 public:
  LdniSolid(std::shared_ptr<const LdniModel::Parts> parts, const Affine3& map, const Box3& bounds)
      : parts_(std::move(parts)),
        to_widths_(composed(to_widths(parts_->ldni.grid()), inverse(map))),
        bounds_(bounds) {}

  [[nodiscard]] Box3 bounds() const override { return bounds_; }
  [[nodiscard]] std::unique_ptr<Section> section(double z) const override {
    return std::make_unique<LdniSection>(parts_, to_widths_, z);
  }

 private:
  std::shared_ptr<const LdniModel::Parts> parts_;
  Affine3 to_widths_;
  Box3 bounds_;
};

LdniModel::Parts parts_of(Ldni ldni) {
  LdniBlocks blocks(ldni);
  return {std::move(ldni), std::move(blocks)};
}

}  // namespace

LdniModel::LdniModel(Ldni ldni)
    : parts_(std::make_shared<const Parts>(parts_of(std::move(ldni)))) {}

Box3 LdniModel::bounds_under(const Affine3& map) const {
  const LdniGrid& grid = parts_->ldni.grid();
  const double w = grid.width();
  const Affine3 from_widths =
      composed(map, composed(translation(grid.origin()), scaling({w, w, w})));
  Box3 box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const LdniRays& rays = parts_->ldni.axes()[axis];
    for (int j = 0; j < grid.resolution(); ++j) {
      for (int i = 0; i < grid.resolution(); ++i) {
        for (const LdniSample& sample : rays.of(grid.ray(i, j))) {
          std::array<double, 3> p{};
          p[axis] = static_cast<double>(sample.depth) / LdniGrid::kUnits;
          p[(axis + 1) % 3] = i;
          p[(axis + 2) % 3] = j;
          box = box.with(from_widths({p[0], p[1], p[2]}));
        }
      }
    }
  }
  return box;
}

std::shared_ptr<const Solid> LdniModel::placed(const Affine3& map) const {
  Box3 box = bounds_under(map);
  const auto reach = [&](std::size_t k) {
    const auto& row = map.rows[k];
    return kOff * parts_->ldni.grid().width() * length({row[0], row[1], row[2]});
  };
  const Vec3 more{reach(0), reach(1), reach(2)};
  if (!box.empty()) box = {box.low - more, box.high + more};
  return std::make_shared<LdniSolid>(parts_, map, box);
}

std::string LdniModel::size_text() const {
  return size_text_of(parts_->ldni);
}

std::string size_text_of(const Ldni& ldni) {
  return fmt::format("{0} x {0} rays an axis, {1} samples", ldni.grid().resolution(),
                     ldni.samples());
}

}  // namespace slipstick
