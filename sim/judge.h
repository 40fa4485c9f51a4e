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
/// Both are drawn on pixels: the solid S by the even-odd rule, the deposit D as the pixels whose centre is
/// in a bead. A pixel of D next to another, also at a corner, is the same material (8-connected); free
/// pixels are together where they share a side (4-connected).
///
/// A part p of S (or of the free space of S) *meets* a part q of D (or of its free space) where they have
/// at least `speck_mm2` in common, or where no other q has more of p. The second clause keeps the smallest
/// island and the smallest hole accountable; the first keeps a pixel of roughness from counting.
///
/// - Material of D that meets no part of S is stray (a skirt, a prime line). It is taken out of D before
///   all that follows, and its area is reported.
/// - `components_wrong` counts the parts of S and of D that do not meet exactly one partner which in turn
///   meets only them: an island missing, broken in two, or grown together with another.
/// - `holes_wrong` counts the same between the free space of S (the outside and each hole) and that of D:
///   a hole closed up, joined with the outside, or cut in two. Free space of D that meets no free space of
///   S is a void, as the cells of sparse infill are, and never wrong.

/// Closed loops in mm.
using Contours = std::vector<std::vector<Vec2>>;

struct JudgeOptions {
  double pixel = 0.05;      ///< mm.
  double speck_mm2 = 0.02;  ///< mm²: about an eighth of the end of a bead.
};

/// The finding on one layer.
struct LayerVerdict {
  int components = 0;        ///< Parts of S.
  int holes = 0;             ///< Parts of the free space of S, less the outside.
  int components_wrong = 0;
  int holes_wrong = 0;
  double solid_mm2 = 0;      ///< Area of S.
  double area_error = 0;     ///< Area of D outside S over the area of S, stray material not counted.
  double void_mm2 = 0;       ///< Voids of D.
  double stray_mm2 = 0;      ///< Stray material.
};

/// Judges `beads` by `contours`. \pre The options are > 0.
[[nodiscard]] LayerVerdict judge_layer(std::span<const ExtrudedSegment> beads,
                                       const Contours& contours, const JudgeOptions& options = {});

}  // namespace slipstick
