#pragma once

#include <memory>

#include "core/formats/point_cloud.h"
#include "core/solid/rbf_model.h"

namespace slipstick {

struct RbfFitOptions {
  /// How much a local approximation may be off in return for reach: smaller gives more functions.
  double tolerance = 2e-6;
};

/// What came of a fit.
struct RbfFit {
  std::unique_ptr<RbfModel> model;
  std::size_t surface_functions = 0;  ///< About points; the paper's count.
  std::size_t fill_functions = 0;     ///< For the inside.
  double diagonal = 0;                ///< Of the points' box, in their units.
  double mean_value = 0;              ///< Mean |f| at the points: to first order their distance.
};

/// Fits points by adaptively supported RBFs (Ohtake, Belyaev, Seidel 2004): centres are chosen
/// among the points until supports overlap enough at every one, supports as large as the local
/// error allows, the rest corrected by least squares. The same bits for the same points, on every
/// machine. \return kInput if a
/// coefficient is beyond what a model may have.
[[nodiscard]] Result<RbfFit> fit_rbf(const PointCloud& cloud, const RbfFitOptions& options = {});

/// Reads and fits. \return kInput as `read_point_cloud` and `fit_rbf`, with `name`.
[[nodiscard]] Result<std::unique_ptr<RbfModel>> load_point_model(std::string_view bytes,
                                                                 std::string_view name);

}  // namespace slipstick
