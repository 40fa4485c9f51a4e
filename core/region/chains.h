#pragma once

#include <vector>

#include "core/image/bit_image.h"
#include "core/region/distance.h"

namespace slipstick {

/// A node of the lattice.
struct Node {
  int column = 0;
  int row = 0;

  friend constexpr bool operator==(const Node&, const Node&) = default;
};

/// A line of nodes, each beside the next; one node if it stands alone.
struct Chain {
  std::vector<Node> nodes;
  bool closed = false;   ///< The last is beside the first.
  bool is_spur = false;  ///< Its back ends freely, its front, the root, hangs on something else.
};

/// The lines of `thin` (an image worn to lines one node wide) outside `kept`, cut where three or
/// more meet; where a line meets `kept`, its chain ends with the node of `kept` it touches.
///
/// Two nodes are beside each other if they share a side, or a corner and no third node sits in it.
[[nodiscard]] std::vector<Chain> chains_of(const BitImage& thin, const BitImage& kept);

}  // namespace slipstick
