#include "core/contour/farthest_seen.h"

#include <algorithm>
#include <cstdint>

#include "core/contour/wedge.h"

namespace slipstick {
namespace {

using IntegerRay = Ray<std::int64_t>;

IntegerRay towards(GridPoint to, GridPoint from) {
  return {std::int64_t{to.x} - from.x, std::int64_t{to.y} - from.y};
}

}  // namespace

std::size_t farthest_seen(const Corridor& corridor, std::size_t from, std::size_t limit) {
  const auto points = [&](std::size_t k) -> const auto& {
    return corridor.points(k < corridor.size() ? k : k - corridor.size());
  };
  const GridPoint origin = points(from)[Corridor::kOwnPlace];
  std::size_t seen = from + 1;
  Wedge<std::int64_t> wedge(towards(points(seen).front(), origin),
                            towards(points(seen).back(), origin));
  const std::size_t end = std::min(limit, from + Wedge<std::int64_t>::kSpanMax);
  for (std::size_t k = from + 2; k <= end; ++k) {
    const auto& window = points(k);
    const IntegerRay inside = towards(window.front(), origin);
    const IntegerRay outside = towards(window.back(), origin);
    if (!wedge.meets(inside, outside)) break;
    if (wedge.sees(towards(window[Corridor::kOwnPlace], origin))) seen = k;
    if (!wedge.pass(inside, outside)) break;
  }
  return seen;
}

}  // namespace slipstick
