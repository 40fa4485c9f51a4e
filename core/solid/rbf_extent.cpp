#include "core/solid/rbf_extent.h"

#include <vector>

#include "core/solid/rbf_field.h"

namespace slipstick {
namespace {

// Halvings of the box of the centres, and cells looked at: with damaged files, where bounds say
// nothing, the box of the cells is given, which is only too large.
constexpr int kHalvings = 11;
constexpr int kCellsMax = 1 << 20;

class Extent {
 public:
  explicit Extent(const Affine3& map) : to_model_(inverse(map)) {}

  void visit(const Box3& cell, std::span<const RbfFunction> near, int halvings) {
    if (holds(cell)) return;
    const Box3 in_model = image_of(to_model_, cell);
    const std::vector<RbfFunction> kept = rbf_narrowed(near, in_model);
    const Cover cover = rbf_cover(kept, in_model);
    if (cover == Cover::kOutside) return;
    if (cover == Cover::kInside || halvings == 0 || ++cells_ > kCellsMax) {
      found_ = found_.with(cell.low).with(cell.high);
      return;
    }
    const Vec3 middle = cell.centre();
    for (int part = 0; part < 8; ++part) {
      const bool x = (part & 1) != 0, y = (part & 2) != 0, z = (part & 4) != 0;
      visit({{x ? middle.x : cell.low.x, y ? middle.y : cell.low.y, z ? middle.z : cell.low.z},
             {x ? cell.high.x : middle.x, y ? cell.high.y : middle.y, z ? cell.high.z : middle.z}},
            kept, halvings - 1);
    }
  }

  [[nodiscard]] const Box3& found() const { return found_; }

 private:
  [[nodiscard]] bool holds(const Box3& cell) const {
    return found_.low.x <= cell.low.x && found_.low.y <= cell.low.y && found_.low.z <= cell.low.z &&
           found_.high.x >= cell.high.x && found_.high.y >= cell.high.y &&
           found_.high.z >= cell.high.z;
  }

  Affine3 to_model_;
  Box3 found_;
  int cells_ = 0;
};

}  // namespace

Box3 rbf_extent(std::span<const RbfFunction> functions, const Affine3& map) {
  Box3 all;
  for (const RbfFunction& f : functions) {
    const Vec3 reach = f.radius * Vec3{1, 1, 1};
    const Box3 box = image_of(map, {f.centre - reach, f.centre + reach});
    all = all.with(box.low).with(box.high);
  }
  Extent extent(map);
  extent.visit(all, functions, kHalvings);
  return extent.found();
}

}  // namespace slipstick
