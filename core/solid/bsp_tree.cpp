#include "core/solid/bsp_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace slipstick {
namespace {

bool acceptable(const BspPlane& plane) {
  const auto within = [](double c) { return std::abs(c) <= BspTree::kCoefficientMax; };
  const Vec3 n = plane.normal;
  return within(n.x) && within(n.y) && within(n.z) && within(plane.offset) &&
         (n.x != 0 || n.y != 0 || n.z != 0);
}

tl::unexpected<Error> bad_node(std::size_t node, std::string_view what) {
  return fail(ErrorCode::kInput,
              fmt::format("node {} {}; the tree is damaged, make it again", node, what));
}

}  // namespace

Result<BspTree> BspTree::of(std::vector<BspNode> nodes) {
  std::vector<int> depths(nodes.size());
  if (!depths.empty()) depths[0] = 1;
  const auto count = static_cast<BspChild>(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!acceptable(nodes[i].plane)) return bad_node(i, "has no plane");
    if (depths[i] == 0) return bad_node(i, "is nobody's child");
    if (depths[i] > kDepthMax) return bad_node(i, "lies too deep");
    for (const BspChild child : {nodes[i].front, nodes[i].back}) {
      if (child == kBspInside || child == kBspOutside) continue;
      if (child <= static_cast<BspChild>(i) || child >= count)
        return bad_node(i, "has no such child");
      int& depth = depths[static_cast<std::size_t>(child)];
      if (depth != 0) return bad_node(i, "shares a child");
      depth = depths[i] + 1;
    }
  }
  return BspTree(std::move(nodes));
}

BspTree BspTree::half_space(const BspPlane& plane) {
  SLIPSTICK_CHECK(acceptable(plane));
  return BspTree({{plane, kBspOutside, kBspInside}});
}

BspTree::Depth BspTree::depth() const {
  std::vector<int> depths(nodes_.size(), 0);
  Depth depth;
  double sum = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (const BspChild child : {nodes_[i].front, nodes_[i].back}) {
      if (child >= 0) {
        depths[static_cast<std::size_t>(child)] = depths[i] + 1;
      } else {
        sum += depths[i] + 1;
        depth.longest = std::max(depth.longest, depths[i] + 1);
      }
    }
  }
  depth.mean = nodes_.empty() ? 0 : sum / static_cast<double>(nodes_.size() + 1);
  return depth;
}

}  // namespace slipstick
