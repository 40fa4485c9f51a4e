#pragma once

#include "core/base/box.h"
#include "core/expr/tape.h"

namespace slipstick {

/// The box of {f <= 0} within `box`, never too small, and too large by at most 1/4096 of the
/// largest side in z, where prints begin, and 1/512 in x and y, unless the search gives up. Empty
/// if nothing is inside.
///
/// Branch and bound from each of the six sides: intervals show where nothing is, points where
/// something is. Gives up tightening a side after `kExtentBoxesMax` boxes and then returns what is
/// certain.
[[nodiscard]] Box3 extent(const Tape& tape, const Box3& box);

inline constexpr int kExtentBoxesMax = 10'000;

}  // namespace slipstick
