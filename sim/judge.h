#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vec.h"
#include "sim/defect.h"
#include "sim/deposit.h"
#include "sim/pixel_image.h"

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
/// `speck_mm2` in common, or where q is the one that has most of p (the first of several): the
/// second keeps the smallest accountable, the first keeps a pixel of roughness from counting.
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
/// A *bare rim* is a place within `rim_mm` of the contours, inside, that D leaves free and that has
/// room for a square of `least_mm`: a perimeter that was not laid.
///
/// What lies more than `reach_mm` beyond all that was laid in the layer below, voids taken as
/// closed, lies *in the air*. That is wrong where no solid is wanted, and for a piece of D that
/// nothing holds at all, skirt included; anywhere else it is a bridge or an overhang that the solid
/// asks for. Less than a square of `least_mm` is not accountable. The first layer lies on the bed.
///
/// Necks and gaps narrower than a pixel are beyond what pixels can tell and are given the benefit
/// of the doubt; the contours' own count of islands and holes does not depend on pixels.

/// Closed loops in mm.
using Contours = std::vector<std::vector<Vec2>>;

struct JudgeOptions {
  double pixel = 0.05;      ///< mm.
  double speck_mm2 = 0.02;  ///< mm²: about an eighth of the end of a bead.
  double rim_mm = 0.4;      ///< How deep perimeters must cover the solid.
  double reach_mm = 0.45;   ///< A bead may stand out so far over what is below.
  double least_mm = 0.25;   ///< Side of the least bare or hanging place.
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
  double void_side = 0;  ///< mm: of the largest square in one.
  Vec2 void_place;       ///< Its middle.
  double stray_mm2 = 0;  ///< Stray material.
  double overhang_mm2 = 0;      ///< Bridges and overhangs that the solid asks for.
  bool touches = false;         ///< Whether any material meets an island.
  std::vector<Defect> defects;  ///< What is counted above, `kDefectsPlaced` of each kind at most,
                                ///< and bare rims and material in the air.

  static constexpr int kDefectsPlaced = 64;
};

/// A layer as the judge saw it, for the next layer and for the topology of the print.
struct JudgedLayer {
  LayerVerdict verdict;
  PixelImage wanted;   ///< The islands.
  PixelImage laid;     ///< All that was laid, stray material included.
  PixelImage shape;    ///< D, its voids filled, without stray material.
  PixelImage support;  ///< All that was laid, voids filled.
};

/// Judges `beads` by `contours`. `below` is the support of the layer below; nothing where that is
/// the bed, or not known. \pre The options are > 0; `below` has pixels of that size.
[[nodiscard]] JudgedLayer judge_layer_over(const std::optional<PixelImage>& below,
                                           std::span<const ExtrudedSegment> beads,
                                           const Contours& contours, const JudgeOptions& options);

/// The verdict alone, on a layer of which it is not asked what it lies on.
[[nodiscard]] LayerVerdict judge_layer(std::span<const ExtrudedSegment> beads,
                                       const Contours& contours, const JudgeOptions& options = {});

}  // namespace slipstick
