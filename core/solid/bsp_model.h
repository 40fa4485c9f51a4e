#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/solid/bsp_tree.h"
#include "core/solid/solid.h"

namespace slipstick {

/// A partition tree as a solid: a point is inside if the path of its signs ends in an inside leaf.
///
/// Which side of a plane a point of the print is on is the sign of (a x + b y) + c, where a, b and
/// c are the plane in the print's frame at the point's height. There is no tolerance. Rounding is
/// monotone, so along a row, along a column and over a rectangle that value is as well, bit for
/// bit: the corners decide for a rectangle, and along a row a plane is crossed once. Slicing fills
/// the rectangles in which all paths are one, and every bit is that of the point's own path.
class BspModel final : public Model {
 public:
  /// Nothing of a solid may reach farther.
  static constexpr double kReach = 1e6;

  /// \return kInput if the inside of the tree is not bounded.
  [[nodiscard]] static Result<std::unique_ptr<BspModel>> of(BspTree tree);

  [[nodiscard]] Box3 bounds_under(const Affine3& map) const override;
  [[nodiscard]] std::shared_ptr<const Solid> placed(const Affine3& map) const override;
  [[nodiscard]] std::string_view kind() const override { return "bsp"; }
  [[nodiscard]] std::string size_text() const override;

  [[nodiscard]] const BspTree& tree() const { return *tree_; }

 private:
  BspModel(std::shared_ptr<const BspTree> tree, const Box3& box)
      : tree_(std::move(tree)), box_(box) {}

  std::shared_ptr<const BspTree> tree_;
  Box3 box_;  // holds the solid with room to spare; empty if it is
};

}  // namespace slipstick
