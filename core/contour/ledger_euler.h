#pragma once

#include <cstdint>

#include "core/contour/ledger_runs.h"

namespace slipstick {

/// The Euler number of the nodes inside, each as a square cell: closed cells where `touch` is
/// `kCorners` (vertices - edges + squares), open ones where it is `kFaces` (cells - pairs that
/// share a side + fours that share a corner).
[[nodiscard]] std::int64_t euler_number(const BitImage& image, Touch touch);

/// The same of what the cells of `a` and `b` have in common as sets of points: closed cells also
/// meet in sides and corners where no cell is in both. \pre One grid.
[[nodiscard]] std::int64_t euler_number_in_common(const BitImage& a, const BitImage& b,
                                                  Touch touch);

}  // namespace slipstick
