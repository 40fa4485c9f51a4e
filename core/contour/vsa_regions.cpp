#include "core/contour/vsa_regions.h"

#include <algorithm>

#include "core/contour/cluster.h"

namespace slipstick {
namespace {

// Fewer regions would ask for a loop of one or two edges.
constexpr std::size_t kRegionsMin = 3;

}  // namespace

std::vector<std::size_t> vsa_regions(const LoopView& loop, int alpha) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const GridPoint p = loop.vertex(i);
    points.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  }
  const std::size_t wanted =
      std::max(kRegionsMin, loop.size() / static_cast<std::size_t>(std::max(alpha, 1)));
  return cluster(points, Connection::kClosed, wanted);
}

}  // namespace slipstick
