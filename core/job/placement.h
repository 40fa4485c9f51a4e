#pragma once

#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/job/settings.h"
#include "core/solid/solid.h"

namespace slipstick {

/// How a model is to lie on the bed.
struct PlacementRequest {
  double unit = 1;  ///< mm of one unit of the model.
  double scale = 1;
  std::optional<Vec3> fit;  ///< Scaled evenly to fill this size (mm); then `scale` is on top of it.
  Vec3 direction{0, 0, 1};  ///< The slicing direction in the model's frame; it becomes +z.
  Vec3 rotate{0, 0, 0};     ///< Degrees about x, y, z, after that.
};

/// A model lying on the bed.
struct PlacedSolid {
  std::shared_ptr<const Solid> solid;
  Box3 bounds;       ///< mm; lowest point at z = 0.
  Affine3 to_model;  ///< From the print's frame to the model's own.
};

/// Places `model` with its lowest point at z = 0 and its middle over `bed_centre`.
/// \return kInput if the solid is empty or a factor is not a positive number.
[[nodiscard]] Result<PlacedSolid> place_on_bed(const Model& model, const PlacementRequest& request,
                                               Vec2 bed_centre);

/// The middle of the printer's bed.
[[nodiscard]] Vec2 bed_centre(const PrinterSettings& printer);

/// \return kInput if `bounds` is larger than or reaches out of what `printer` can print; on a round
/// bed all corners of `bounds` must fit.
[[nodiscard]] Result<void> check_build_volume(const Box3& bounds, const PrinterSettings& printer);

}  // namespace slipstick
