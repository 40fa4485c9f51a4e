#include "core/solid/bsp_extent.h"

#include "core/solid/bsp_cell.h"

namespace slipstick {
namespace {

class Extent {
 public:
  Extent(const BspTree& tree, const Affine3& map) : tree_(tree), map_(map) {}

  void visit(BspChild at, const BspCell& cell) {
    if (at == kBspOutside || cell.empty()) return;
    Box3 box = found_;
    cell.for_each_corner([&](Vec3 p) { box = box.with(map_(p)); });
    if (box == found_) return;  // whatever is inside the cell is nothing new
    if (at == kBspInside) {
      found_ = box;
      return;
    }
    const BspNode& node = tree_.nodes()[static_cast<std::size_t>(at)];
    visit(node.back, cell.behind_of(node.plane));
    visit(node.front, cell.behind_of(flipped(node.plane)));
  }

  [[nodiscard]] const Box3& found() const { return found_; }

 private:
  const BspTree& tree_;
  const Affine3& map_;
  Box3 found_;
};

}  // namespace

Box3 bsp_extent(const BspTree& tree, const Box3& within, const Affine3& map) {
  if (within.empty()) return {};
  Extent extent(tree, map);
  extent.visit(tree.root(), BspCell(within));
  return extent.found();
}

}  // namespace slipstick
