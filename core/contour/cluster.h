#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/vec.h"

namespace slipstick {

/// How the edges of a contour hang together.
enum class Connection { kOpen, kClosed };

/// Variational segmentation (paper, section 5.1): regions of a contour, each close to a line.
///
/// `points` are the vertices in order; edge i joins vertex i to the next. Starts from seeds spread
/// evenly, grows regions from a queue keyed by distortion, moves each proxy to its best line and
/// each seed to the edge nearest to it, for 20 rounds or until nothing changes. Deterministic; ties
/// go to the lower edge.
///
/// \param count how many regions are wanted, 1 to the number of edges.
/// \return the first edges of the regions, ascending; regions are runs of edges up to the next
/// first. At
///   most `count`. An open contour's begin with 0.
[[nodiscard]] std::vector<std::size_t> cluster(std::span<const Vec2> points, Connection connection,
                                               std::size_t count);

}  // namespace slipstick
