#pragma once

#include <optional>

#include "core/base/affine.h"
#include "core/base/result.h"
#include "core/solid/solid.h"

namespace slipstick {

/// \file
/// How thin a solid and its gaps are, for the r of the paper's theorem 1 (section 3.3).
///
/// An estimate from sections along three axes, evenly spaced. Along every row and column of nodes,
/// what lies between two changes of side is a chord; where the surfaces at its ends face each other
/// (region/facing.h), what fits between them is exact for plates, rods and balls at any angle,
/// since places and normals are found between the nodes.
///
/// - Seen is what a row or column of some section meets: surely a plate of a step, or a rod of
///   three, that reaches from one section to the next. Where thickness changes from place to place,
///   the thinnest place is as a rule between two sections, and what is found a little thicker.
/// - Sides count up to 15 degrees from parallel, more between sides a few steps apart. Edges, and
///   wedges, which have no thickness of their own, are left out; those sharper than 4 degrees are
///   not told from plates, and a plate that ends in one may look a tenth thinner.

/// Chords that are looked at in one section, evenly chosen by length if there are more.
inline constexpr std::size_t kFeatureChordsMax = 512;

/// How closely it is looked.
struct FeatureSampling {
  int sections = 32;  ///< Along each axis, >= 1.
  int steps = 1000;   ///< Along the longest side of the solid, >= 1.
};

struct ThinPlace {
  double mm = 0;
  Vec3 at;  ///< In the middle between the two sides.
};

struct FeatureSizes {
  std::optional<ThinPlace> feature;  ///< Where the solid is thinnest; none if no sides face.
  std::optional<ThinPlace> gap;      ///< Where the void between two sides is.
  int sections = 0;                  ///< That were looked at.
  double step = 0;                   ///< mm from node to node.

  /// The r that was found: half of the smaller one.
  [[nodiscard]] std::optional<double> radius() const;
  /// What theorem 1 wants sampling distances to be below, r/√3, in mm.
  [[nodiscard]] std::optional<double> sampling_limit() const;
};

/// \param map of the model onto the bed; \param bounds of the model under it, not empty.
/// \return kInput if f is not a number somewhere, or the solid is too large to be sampled.
[[nodiscard]] Result<FeatureSizes> feature_sizes(const Model& model, const Affine3& map,
                                                 const Box3& bounds,
                                                 const FeatureSampling& sampling = {});

}  // namespace slipstick
