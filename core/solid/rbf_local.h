#pragma once

#include <optional>
#include <vector>

#include "core/formats/point_cloud.h"
#include "core/solid/rbf_function.h"
#include "core/solid/rbf_points.h"

namespace slipstick {

/// One local approximation: w - h(u, v) about a point, where w runs along the mean normal and h is
/// the quadratic that fits the weighted points best (Ohtake et al. 2004, section 3).
struct LocalFit {
  RbfFunction function;
  double mean_square = 0;  ///< Weighted, of the points in the support.
};

/// Of the points within `radius` of point `centre` on its own sheet; those beyond a sharp edge or
/// another wall are held against it. Nothing where the normals cancel.
[[nodiscard]] std::optional<LocalFit> fit_local(const PointCloud& cloud, const PointIndex& index,
                                                std::uint32_t centre, double radius);

/// The fit about `centre` whose support is as large as its error allows: of a ladder of radii, the
/// one with the least `mean_square` / L² + (`tolerance` · L / radius)², where L is the diagonal.
/// \pre `centre` is one of the points.
[[nodiscard]] LocalFit fit_adaptive(const PointCloud& cloud, const PointIndex& index,
                                    std::uint32_t centre, double tolerance);

}  // namespace slipstick
