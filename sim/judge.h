#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec.h"
#include "sim/deposit.h"

namespace slipstick {

/// \file
/// Whether what was printed is what was to be printed: one layer's beads against its contours.
///
/// What is wanted comes from the contours themselves: an island is a loop that solid lies in, a
/// hole one that free space lies in. Where they lie, and what was laid where, is drawn on pixels:
/// the deposit D as the pixels whose centre is in a bead. Pixels of D next to each other, also at a
/// corner, are the same material (8-connected); free pixels are together where they share a side
/// (4-connected).
///
/// An island or hole p *meets* a part q of D (or of its free space) where they have at least
/// `speck_mm2` in common, or where no other q has more of p: the second keeps the smallest
/// accountable, the first keeps a pixel of roughness from counting.
///
/// - Material of D that meets no island is stray (a skirt, a prime line). It is taken out of D
/// before all
///   that follows, and its area is reported.
/// - `components_wrong` counts islands that are missing (nothing of D within a pixel of them), cuts
/// (an
///   island that meets more parts of D than its own pixels have parts) and joints (a part of D that
///   meets several islands, unless their own pixels touch).
/// - `holes_wrong` counts the same between the free space of the contours (the outside and each
/// hole) and
///   that of D: holes closed up, cut, or joined with each other or the outside. Free space of D
///   that meets none is a void, as the cells of sparse infill are, and never wrong.
///
/// Necks and gaps narrower than a pixel are beyond what pixels can tell and are given the benefit
/// of the doubt; the contours' own count of islands and holes does not depend on pixels.

/// Closed loops in mm.
using Contours = std::vector<std::vector<Vec2>>;

struct JudgeOptions {
  double pixel = 0.05;      ///< mm.
  double speck_mm2 = 0.02;  ///< mm²: about an eighth of the end of a bead.
};

/// The finding on one layer.
struct LayerVerdict {
  int components = 0;  ///< Islands of the contours.
  int holes = 0;       ///< Holes of the contours.
  int components_wrong = 0;
  int holes_wrong = 0;
  double solid_mm2 = 0;  ///< Area of the islands.
  double area_error =
      0;                 ///< Area of D outside the islands over theirs, stray material not counted.
  double void_mm2 = 0;   ///< Voids of D.
  double stray_mm2 = 0;  ///< Stray material.
};

/// Judges `beads` by `contours`. \pre The options are > 0.
[[nodiscard]] LayerVerdict judge_layer(std::span<const ExtrudedSegment> beads,
                                       const Contours& contours, const JudgeOptions& options = {});

}  // namespace slipstick
