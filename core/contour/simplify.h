#pragma once

#include <cstddef>
#include <cstdint>

#include "core/contour/contour_set.h"
#include "core/contour/outline.h"

namespace slipstick {

/// \file
/// From placed contours to outlines with fewer edges (paper, section 5). Whatever the method, an
/// edge only replaces a run of vertices if it crosses every stick between them, so every `Outline`
/// separates the same samples as the image and is free of self-intersection (propositions 3 to 5).

/// Where on its stick `simplify_fewest` may put a vertex: at both ends of its window and at the
/// contour's own place, or at that alone.
enum class Candidates : std::uint8_t { kThree, kOne };

struct SimplifyOptions {
  double tolerance =
      0.025;       ///< mm: Fréchet distance between an edge and the run it replaces, at most.
  int alpha = 10;  ///< The paper's clustering ratio, for `simplify_vsa`. At least 1.
  Candidates candidates = Candidates::kThree;
};

struct Simplified {
  Outline outline;
  std::size_t edges_before = 0;
  double max_deviation = 0;            ///< mm, bound of the Fréchet distance.
  double max_regional_distortion = 0;  ///< mm³, the paper's D' (equation 5).
};

/// The fewest edges that windows of `tolerance` about the places allow, vertices at one of the
/// candidates on their sticks; among the fewest the least distortion. Near-optimal: `EdgeSearch`
/// says what its search leaves out. Where the Fréchet distance found is beyond the tolerance,
/// windows are narrowed there and the loop is searched again.
[[nodiscard]] Simplified simplify_fewest(const ContourSet& contours,
                                         const SimplifyOptions& options);

/// All vertices as they are.
[[nodiscard]] Simplified keep_all(const ContourSet& contours);

/// The paper's: variational segmentation (section 5.1), then verification and splitting (5.2).
[[nodiscard]] Simplified simplify_vsa(const ContourSet& contours, const SimplifyOptions& options);

/// Each edge as long as it may be, loop by loop from its first vertex. Quick; for offsets and
/// infill.
[[nodiscard]] Simplified simplify_greedy(const ContourSet& contours,
                                         const SimplifyOptions& options);

}  // namespace slipstick
