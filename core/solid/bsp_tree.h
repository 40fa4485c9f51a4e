#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace slipstick {

/// {p : dot(normal, p) + offset = 0}; the front is where that is positive, the back is the rest,
/// the plane itself included.
struct BspPlane {
  Vec3 normal;
  double offset = 0;

  friend bool operator==(const BspPlane&, const BspPlane&) = default;
};

/// Where a path through a tree goes on: a node, or one of two leaves.
using BspChild = std::int32_t;
inline constexpr BspChild kBspOutside = -1;
inline constexpr BspChild kBspInside = -2;

struct BspNode {
  BspPlane plane;
  BspChild front = kBspOutside;
  BspChild back = kBspInside;

  friend bool operator==(const BspNode&, const BspNode&) = default;
};

/// Appends a node and what `front` and `back`, called in this order, append below it. A node whose
/// sides are one and the same leaf is left out. \return Where a path goes on.
template <typename Front, typename Back>
BspChild append_node(std::vector<BspNode>& nodes, const BspPlane& plane, Front front, Back back) {
  const std::size_t node = nodes.size();
  nodes.push_back({plane});
  const BspChild in_front = front();
  const BspChild behind = back();
  if (in_front < 0 && in_front == behind) {
    nodes.resize(node);
    return in_front;
  }
  nodes[node].front = in_front;
  nodes[node].back = behind;
  return static_cast<BspChild>(node);
}

/// A binary space partition: convex cells that are inside or outside (Thibault and Naylor 1987).
///
/// Invariant: node 0 is the root if there is a node, every other node is the child of exactly one
/// node before it, no path is longer than `kDepthMax`, every plane is finite and has a normal.
class BspTree {
 public:
  static constexpr int kDepthMax = 512;
  static constexpr double kCoefficientMax = 1e18;

  /// The tree without a node: all is outside.
  BspTree() = default;

  /// \return kInput, naming the node, if the nodes do not keep the invariant.
  [[nodiscard]] static Result<BspTree> of(std::vector<BspNode> nodes);
  /// The back of a plane. \pre The plane is finite and has a normal.
  [[nodiscard]] static BspTree half_space(const BspPlane& plane);

  [[nodiscard]] std::span<const BspNode> nodes() const { return nodes_; }
  [[nodiscard]] BspChild root() const { return nodes_.empty() ? kBspOutside : 0; }

  /// The longest path, and the mean over all leaves: the paper's complexity (table 2).
  struct Depth {
    int longest = 0;
    double mean = 0;
  };
  [[nodiscard]] Depth depth() const;

 private:
  explicit BspTree(std::vector<BspNode> nodes) : nodes_(std::move(nodes)) {}

  std::vector<BspNode> nodes_;
};

}  // namespace slipstick
