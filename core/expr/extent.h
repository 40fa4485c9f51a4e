#pragma once

#include "core/base/box.h"
#include "core/expr/tape.h"

namespace slipstick {

/// The box of {f <= 0} within `box`, too large by no more than about 1/512 of the largest side, in
/// z, where prints begin, 1/4096. Empty if nothing is inside.
///
/// Branch and bound from each of the six sides: intervals show where nothing is, points where
/// something is; then it is never too small. Where intervals are too wide to come to an end in
/// `kExtentBoxesMax` boxes, whole planes 1/512 of the largest side apart are looked at on a raster
/// of 256 by 256, and what is thinner than that may be missed.
[[nodiscard]] Box3 extent(const Tape& tape, const Box3& box);

inline constexpr int kExtentBoxesMax = 3'000;

}  // namespace slipstick
