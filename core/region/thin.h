#pragma once

#include <array>
#include <cstdint>

#include "core/contour/contour_set.h"
#include "core/image/bit_image.h"
#include "core/region/distance.h"

namespace slipstick {

/// Neighbours of a node, bit i set if that one is inside: east first, then counter-clockwise,
/// diagonals odd.
using Neighbourhood = std::uint8_t;

[[nodiscard]] Neighbourhood neighbourhood(const BitImage& image, int column, int row);

/// Whether a node with these neighbours can change sides without any component or hole appearing,
/// vanishing or merging (digital topology: a simple point). Which neighbours hang together depends
/// on `ambiguity`.
[[nodiscard]] bool is_simple(Neighbourhood neighbours, Ambiguity ambiguity);

struct ThinningOptions {
  /// mm: a last node of a line stays if it is at least so deep; others go, so that corners leave no
  /// spurs.
  double end_depth = 0;
  Ambiguity ambiguity = Ambiguity::kSolid;
};

/// `region` worn away, shallowest nodes first, to `kept` and lines one node wide: a deformation
/// retract, with exactly the components and holes of `region`. \pre `kept` is a part of `region`.
[[nodiscard]] BitImage thinned(const BitImage& region, const BitImage& kept,
                               const DistanceField& depth, const ThinningOptions& options);

}  // namespace slipstick
