#include "core/solid/bsp_merge.h"

#include <utility>

#include "core/solid/bsp_cell.h"
#include "core/solid/bsp_extent.h"
#include "core/solid/bsp_model.h"

namespace slipstick {
namespace {

class Merger {
 public:
  Merger(const BspTree& a, Boolean operation, const BspTree& b)
      : a_(a), b_(b), operation_(operation) {}

  BspChild first(BspChild at, const BspCell& cell) {
    if (at < 0) return leaf_of_first(at == kBspInside, cell);
    const BspNode& node = a_.nodes()[static_cast<std::size_t>(at)];
    return both(node, cell, [this](BspChild child, const BspCell& c) { return first(child, c); });
  }

  [[nodiscard]] std::vector<BspNode> take() { return std::move(nodes_); }

 private:
  BspChild leaf_of_first(bool inside, const BspCell& cell) {
    const bool decides = inside == (operation_ == Boolean::kUnion);
    if (!decides) return second(b_.root(), cell);
    return operation_ == Boolean::kUnion ? kBspInside : kBspOutside;
  }

  BspChild second(BspChild at, const BspCell& cell) {
    if (at < 0) {
      const bool inside = (at == kBspInside) != (operation_ == Boolean::kDifference);
      return inside ? kBspInside : kBspOutside;
    }
    const BspNode& node = b_.nodes()[static_cast<std::size_t>(at)];
    return both(node, cell, [this](BspChild child, const BspCell& c) { return second(child, c); });
  }

  // Goes on with the children whose part of the cell is something.
  template <typename GoOn>
  BspChild both(const BspNode& from, const BspCell& cell, GoOn go_on) {
    const BspCell front = cell.behind_of(flipped(from.plane)), back = cell.behind_of(from.plane);
    if (front.empty()) return go_on(from.back, back.empty() ? cell : back);
    if (back.empty()) return go_on(from.front, front);
    return append_node(
        nodes_, from.plane, [&] { return go_on(from.front, front); },
        [&] { return go_on(from.back, back); });
  }

  const BspTree& a_;
  const BspTree& b_;
  Boolean operation_;
  std::vector<BspNode> nodes_;
};

// Where there is anything, with room around it: as small as can be, for the sake of rounding. No
// inside cell reaches its faces, so that none reaches beyond them either.
Box3 room_of(const BspTree& a, const BspTree& b) {
  constexpr double kFar = 2 * BspModel::kReach;
  const Box3 all{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
  Box3 box;
  for (const BspTree* tree : {&a, &b}) {
    const Box3 extent = bsp_extent(*tree, all, {});
    if (!extent.empty()) box = box.with(extent.low).with(extent.high);
  }
  if (box.empty()) return all;
  const Vec3 more = 0.5 * box.size() + 1e-3 * Vec3{1, 1, 1};
  return Box3{box.low - more, box.high + more}.within(all);
}

}  // namespace

Result<BspTree> merged(const BspTree& a, Boolean operation, const BspTree& b) {
  Merger merger(a, operation, b);
  const BspChild root = merger.first(a.root(), BspCell(room_of(a, b)));
  if (root == kBspInside) {
    return fail(ErrorCode::kInput, "the whole of space is inside; use bounded solids");
  }
  return BspTree::of(merger.take());
}

}  // namespace slipstick
