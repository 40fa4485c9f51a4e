#pragma once

#include "core/contour/contour_set.h"

namespace slipstick {

/// \file
/// The paper's placements from bits alone (section 4): vertices slide towards their neighbours.
///
/// Both move each vertex by τ = 0.4 of the way a round, all at once, until they move by less than
/// 10^-3 of a cell on average, or for `kSmoothingRoundsMax` rounds.

inline constexpr double kSmoothingRate = 0.4;          ///< The paper's τ.
inline constexpr double kSmoothingMovementEnd = 1e-3;  ///< Of a cell, the mean of a round.
inline constexpr int kSmoothingRoundsMax = 1000;

/// Towards where the line between the neighbours meets the stick: sliding on sticks.
void place_sliding(ContourSet& contours);

/// Towards the middle of the neighbours, brought back to the nearest point of the stick: what the
/// paper compares with (its reference [18]); vertices get stuck.
void place_projection(ContourSet& contours);

}  // namespace slipstick
