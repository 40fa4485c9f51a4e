#include "core/toolpath/thin_beads.h"

#include <algorithm>
#include <cmath>

#include "core/region/chains.h"

namespace slipstick {
namespace {

// Of a line width. A line's free end stays if it is at least so deep; a bead is at most so wide.
constexpr double kEndDepth = 0.15;
constexpr double kWidthMax = 1.6;
// Of a cell: what filament can still be counted out for.
constexpr double kWidthMin = 0.5;
// A spur is what is left of a corner, not a wall, if it deepens this much towards its root (a wall
// keeps its depth; the bisector of a right angle deepens by 0.7) …
constexpr double kCornerSlope = 0.35;
// … or if it is shorter than this many line widths.
constexpr double kSpurLengthMin = 1.0;
// Nodes of a chain may be left out where the bead moves by no more than this part of its half
// width.
constexpr double kStraightening = 0.25;
// A piece ends where the room has changed by this part.
constexpr double kTaper = 0.2;

class BeadMaker {
 public:
  explicit BeadMaker(const ThinRegion& thin) : thin_(thin), grid_(thin.region.grid()) {}

  [[nodiscard]] bool is_corner(const Chain& chain) const {
    if (!chain.is_spur) return false;
    const double length = length_of(chain);
    if (length < kSpurLengthMin * thin_.line_width) return true;
    const double deepens = depth(chain.nodes.front()) - depth(chain.nodes.back());
    return deepens > kCornerSlope * length;
  }

  [[nodiscard]] Bead bead_of(const Chain& chain) const {
    Bead bead;
    bead.role = Role::kThinBead;
    bead.closed = chain.closed;
    const std::vector<std::size_t> corners = corners_of(chain);
    for (const std::size_t i : corners) bead.points.push_back(mm(chain.nodes[i]));
    if (corners.size() == 1) return dot(bead.points[0], width(depth(chain.nodes[0])), bead.role);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      bead.widths.push_back(width(room(chain, corners[i], corners[i + 1])));
    }
    if (bead.closed) bead.widths.push_back(width(room(chain, corners.back(), chain.nodes.size())));
    return bead;
  }

 private:
  [[nodiscard]] Vec2 mm(Node n) const { return {grid_.node_x(n.column), grid_.node_y(n.row)}; }
  [[nodiscard]] double depth(Node n) const { return thin_.depth.at(n.column, n.row) - thin_.edge; }
  [[nodiscard]] double width(double room) const {
    return std::clamp(2 * room, kWidthMin * grid_.width(), kWidthMax * thin_.line_width);
  }
  [[nodiscard]] static Node node(const Chain& chain, std::size_t i) {
    return chain.nodes[i < chain.nodes.size() ? i : 0];
  }

  // How far a straight bead from node `from` to node `to` stays from the edge: depth changes by no
  // more than one goes, so what it leaves aside counts against it.
  [[nodiscard]] double room(const Chain& chain, std::size_t from, std::size_t to) const {
    double least = kWidthMax * thin_.line_width;
    for (std::size_t i = from; i <= to; ++i) {
      const double aside = i == from || i == to ? 0 : off(chain, from, to, i);
      least = std::min(least, depth(node(chain, i)) - aside);
    }
    return least;
  }

  // Distance of node `i` from the straight piece between two others.
  [[nodiscard]] double off(const Chain& chain, std::size_t from, std::size_t to,
                           std::size_t i) const {
    const Vec2 a = mm(node(chain, from)), edge = mm(node(chain, to)) - a;
    const Vec2 v = mm(node(chain, i)) - a;
    const double t = std::clamp(dot(v, edge) / dot(edge, edge), 0.0, 1.0);
    return length(v - t * edge);
  }

  [[nodiscard]] double length_of(const Chain& chain) const {
    double sum = 0;
    for (std::size_t i = 1; i < chain.nodes.size(); ++i) {
      sum += length(mm(chain.nodes[i]) - mm(chain.nodes[i - 1]));
    }
    return sum;
  }

  // The nodes that are kept: as few as straight pieces within the tolerance need, greedily. A
  // closed chain keeps at least three.
  [[nodiscard]] std::vector<std::size_t> corners_of(const Chain& chain) const {
    std::vector<std::size_t> kept{0};
    const std::size_t count = chain.nodes.size();
    const std::size_t reach_max = chain.closed ? std::max<std::size_t>(1, count / 3) : count;
    for (std::size_t at = 0; at + 1 < count;) {
      std::size_t next = at + 1;
      while (next + 1 < count && next + 1 - at <= reach_max && is_straight(chain, at, next + 1)) {
        ++next;
      }
      kept.push_back(next);
      at = next;
    }
    return kept;
  }

  [[nodiscard]] bool is_straight(const Chain& chain, std::size_t from, std::size_t to) const {
    const double here = depth(chain.nodes[from]);
    for (std::size_t i = from + 1; i < to; ++i) {
      const double room = depth(chain.nodes[i]);
      if (off(chain, from, to, i) > kStraightening * room) return false;
      if (std::abs(room - here) > kTaper * here) return false;
    }
    return true;
  }

  const ThinRegion& thin_;
  const SliceGrid& grid_;
};

}  // namespace

std::vector<Bead> thin_beads(const ThinRegion& thin) {
  const ThinningOptions options{thin.edge + kEndDepth * thin.line_width, thin.ambiguity};
  BitImage lines = thinned(thin.region, thin.kept, thin.depth, options);
  const BeadMaker maker(thin);
  // Without its spurs a line still has the topology it had; their roots stay.
  for (const Chain& chain : chains_of(lines, thin.kept)) {
    if (!maker.is_corner(chain)) continue;
    for (std::size_t i = 1; i < chain.nodes.size(); ++i) {
      lines.set(chain.nodes[i].column, chain.nodes[i].row, false);
    }
  }
  std::vector<Bead> beads;
  for (const Chain& chain : chains_of(lines, thin.kept)) {
    // A gap inside a single ring comes down to one node; nothing hangs on it.
    const bool is_needless = thin.edge > 0 && chain.nodes.size() == 1;
    if (!is_needless) beads.push_back(maker.bead_of(chain));
  }
  return beads;
}

}  // namespace slipstick
