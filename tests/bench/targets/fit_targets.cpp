// What the fit of a real scan comes to.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/base/check.h"
#include "core/formats/point_cloud.h"
#include "core/solid/rbf_field.h"
#include "core/solid/rbf_fit.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {
namespace {

constexpr int kPaperFunctions = 21'068;  // table 3, Bunny

std::optional<PointCloud> bunny() {
  const std::string folder = bench::models_folder();
  if (folder.empty()) return {};
  std::ifstream file(folder + "/pts_bunny_34834.ply", std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  auto cloud = read_point_cloud(bytes.str(), "ply");
  SLIPSTICK_CHECK(cloud.has_value());
  return *std::move(cloud);
}

// From `point` along its normal to where the solid's side changes, by halving and without the
// index of the model; `reach` where it does not change within that.
double distance_to_surface(const RbfModel& model, Vec3 point, Vec3 normal, double reach) {
  const Vec3 corner{reach, reach, reach};
  const auto near = rbf_narrowed(model.functions(), {point - corner, point + corner});
  const auto inside = [&](double along) { return rbf_inside(near, point + along * normal); };
  double low = -reach, high = reach;
  if (!inside(low) || inside(high)) return reach;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (inside(middle) ? low : high) = middle;
  }
  return std::abs(low);
}

struct Distances {
  double mean = 0;
  double largest = 0;
};

Distances distances(const RbfFit& fit, const PointCloud& cloud) {
  Distances found;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double distance =
        distance_to_surface(*fit.model, cloud.points[i], cloud.normals[i], 1e-2 * fit.diagonal);
    found.mean += distance / double(cloud.points.size());
    found.largest = std::max(found.largest, distance);
  }
  return found;
}

}  // namespace

std::vector<Row> fit_rows() {
  const auto cloud = bunny();
  if (!cloud) return {};
  const auto before = std::chrono::steady_clock::now();
  const auto fit = fit_rbf(*cloud);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  SLIPSTICK_CHECK(fit.has_value());
  const Distances found = distances(*fit, *cloud);
  const double share = found.mean / fit->diagonal;
  return {
      {fmt::format("RBF fit, {} points of the Bunny: mean distance to the surface",
                   cloud->points.size()),
       "< 1e-4 of the diagonal",
       fmt::format("{:.2e} (largest {:.2e})", share, found.largest / fit->diagonal), share < 1e-4},
      {"RBF fit, the Bunny: functions", fmt::format("paper: {}", kPaperFunctions),
       fmt::format("{} about points and {} for the inside, in {:.1f} s", fit->surface_functions,
                   fit->fill_functions, seconds),
       fit->surface_functions <= kPaperFunctions}};
}

}  // namespace slipstick::targets
