#include "core/solid/bsp_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/solid/bsp_extent.h"
#include "core/solid/bsp_section.h"

namespace slipstick {
namespace {

class BspSolid final : public Solid {
 public:
  BspSolid(const BspTree& tree, const Affine3& map, const Box3& bounds) : bounds_(bounds) {
    const Affine3 to_model = inverse(map);
    auto nodes = std::make_shared<PlacedBspNodes>();
    nodes->reserve(tree.nodes().size());
    for (const BspNode& node : tree.nodes()) {
      const Vec3 n = node.plane.normal;
      const auto along = [&](std::size_t k) {
        return n.x * to_model.rows[0][k] + n.y * to_model.rows[1][k] + n.z * to_model.rows[2][k];
      };
      nodes->push_back(
          {along(0), along(1), along(2), along(3) + node.plane.offset, node.front, node.back});
    }
    nodes_ = std::move(nodes);
    root_ = tree.root();
  }

  [[nodiscard]] Box3 bounds() const override { return bounds_; }
  [[nodiscard]] std::unique_ptr<Section> section(double z) const override {
    return std::make_unique<BspSection>(nodes_, root_, z);
  }

 private:
  std::shared_ptr<const PlacedBspNodes> nodes_;
  BspChild root_ = kBspOutside;
  Box3 bounds_;
};

}  // namespace

Result<std::unique_ptr<BspModel>> BspModel::of(BspTree tree) {
  constexpr double kFar = 2 * kReach;
  const Box3 rough = bsp_extent(tree, {{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}}, {});
  const auto reaches = [&](double c) { return std::abs(c) > kReach; };
  const Vec3 low = rough.low, high = rough.high;
  if (!rough.empty() && (reaches(low.x) || reaches(low.y) || reaches(low.z) || reaches(high.x) ||
                         reaches(high.y) || reaches(high.z))) {
    return fail(ErrorCode::kInput,
                fmt::format("is not bounded: its inside reaches beyond {:g}; intersect it with a "
                            "box or check which side of its planes is inside",
                            kReach));
  }
  Box3 box;
  if (!rough.empty()) {
    // Cells cut out of a huge box are rounded by its size; half the solid more is room for that.
    const Vec3 size = rough.size();
    const double more = 0.5 * std::max({size.x, size.y, size.z}) + kReach * 1e-12;
    box = {low - Vec3{more, more, more}, high + Vec3{more, more, more}};
  }
  return std::unique_ptr<BspModel>(
      new BspModel(std::make_shared<const BspTree>(std::move(tree)), box));
}

Box3 BspModel::bounds_under(const Affine3& map) const {
  return bsp_extent(*tree_, box_, map);
}

std::shared_ptr<const Solid> BspModel::placed(const Affine3& map) const {
  return std::make_shared<BspSolid>(*tree_, map, bounds_under(map));
}

std::string BspModel::size_text() const {
  const BspTree::Depth depth = tree_->depth();
  return fmt::format("{} nodes, mean depth {:.1f}", tree_->nodes().size(), depth.mean);
}

}  // namespace slipstick
