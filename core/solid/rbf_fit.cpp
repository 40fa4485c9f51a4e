#include "core/solid/rbf_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "core/base/rng.h"
#include "core/solid/rbf_correction.h"
#include "core/solid/rbf_fill.h"
#include "core/solid/rbf_local.h"

namespace slipstick {
namespace {

// Supports overlap at each point until their weights sum to this (Ohtake et al.: 1.5).
constexpr double kOverlap = 1.5;
// A centre is the least covered of so many points drawn.
constexpr std::size_t kDrawn = 15;
constexpr std::uint64_t kSeed = 2004;

class Covering {
 public:
  Covering(const PointCloud& cloud, const PointIndex& index)
      : cloud_(cloud), index_(index), open_(cloud.points.size()), overlap_(cloud.points.size()) {
    std::iota(open_.begin(), open_.end(), 0U);
  }

  std::vector<RbfFunction> made(double tolerance) {
    std::vector<RbfFunction> functions;
    while (const auto centre = next_centre()) {
      functions.push_back(fit_adaptive(cloud_, index_, *centre, tolerance).function);
      const RbfFunction& f = functions.back();
      index_.for_each_within(f.centre, f.radius, [&](std::uint32_t i, double square) {
        overlap_[i] += wendland(square, f.radius);
      });
      overlap_[*centre] = std::max(overlap_[*centre], kOverlap);  // never twice
    }
    return functions;
  }

 private:
  std::optional<std::uint32_t> next_centre() {
    std::optional<std::uint32_t> best;
    for (std::size_t drawn = 0; drawn < kDrawn && !open_.empty();) {
      const auto at = static_cast<std::size_t>(rng_.below(open_.size()));
      const std::uint32_t point = open_[at];
      if (overlap_[point] >= kOverlap) {
        open_[at] = open_.back();
        open_.pop_back();
        continue;
      }
      if (!best || overlap_[point] < overlap_[*best]) best = point;
      ++drawn;
    }
    return best;
  }

  const PointCloud& cloud_;
  const PointIndex& index_;
  std::vector<std::uint32_t> open_;  // points that may not be covered yet
  std::vector<double> overlap_;
  Rng rng_{kSeed};
};

double mean_value_of(std::span<const RbfFunction> functions, const PointIndex& index) {
  std::vector<double> weighted(index.points().size()), weights(index.points().size());
  for (const RbfFunction& f : functions) {
    index.for_each_within(f.centre, f.radius, [&](std::uint32_t i, double square) {
      const double weight = wendland(square, f.radius);
      weighted[i] += weight * quadric_at(f.quadric, index.points()[i] - f.centre);
      weights[i] += weight;
    });
  }
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0) sum += std::abs(weighted[i] / weights[i]);
  }
  return sum / static_cast<double>(weights.size());
}

}  // namespace

Result<RbfFit> fit_rbf(const PointCloud& cloud, const RbfFitOptions& options) {
  const PointIndex index(cloud.points);
  std::vector<RbfFunction> functions =
      corrected(Covering(cloud, index).made(options.tolerance), index);
  RbfFit fit;
  fit.surface_functions = functions.size();
  fit.diagonal = length(index.box().size());
  fit.mean_value = mean_value_of(functions, index);
  const std::vector<RbfFunction> fill = fill_between(functions, cloud, index);
  fit.fill_functions = fill.size();
  functions.insert(functions.end(), fill.begin(), fill.end());
  auto model = RbfModel::of(std::move(functions));
  if (!model) return fail(model.error());
  fit.model = *std::move(model);
  return fit;
}

Result<std::unique_ptr<RbfModel>> load_point_model(std::string_view bytes, std::string_view name) {
  const std::size_t dot = name.rfind('.');
  const auto extension = dot == std::string_view::npos ? std::string_view{} : name.substr(dot + 1);
  const auto cloud = read_point_cloud(bytes, extension);
  if (!cloud) return fail(cloud.error().within(name));
  auto fit = fit_rbf(*cloud);
  if (!fit) return fail(fit.error().within(name));
  return std::move(fit->model);
}

}  // namespace slipstick
