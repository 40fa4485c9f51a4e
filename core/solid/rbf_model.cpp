#include "core/solid/rbf_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/check.h"
#include "core/solid/mesh_model_intervals.h"
#include "core/solid/rbf_extent.h"
#include "core/solid/rbf_field.h"

namespace slipstick {
namespace {

using Functions = std::vector<RbfFunction>;

class RbfSection final : public Section {
 public:
  RbfSection(Functions functions, const Affine3& to_model, double z, double outside)
      : functions_(std::move(functions)), to_model_(to_model), z_(z), outside_(outside) {}

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override {
    SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() == inside.size());
    for (std::size_t i = 0; i < xs.size(); ++i) {
      inside[i] = rbf_inside(functions_, to_model_({xs[i], ys[i], z_})) ? 1 : 0;
    }
  }

  bool evaluate(std::span<const double> xs, std::span<const double> ys,
                std::span<double> values) override {
    SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() == values.size());
    for (std::size_t i = 0; i < xs.size(); ++i) {
      values[i] = rbf_value(functions_, to_model_({xs[i], ys[i], z_})).value_or(outside_);
    }
    return true;
  }

  // The map rounds monotonically in every coordinate, so the images of the corners bound the image
  // of every point, bit for bit.
  [[nodiscard]] Narrowed narrowed(const Box2& box) override {
    const Box3 cell =
        image_of(to_model_, {{box.low.x, box.low.y, z_}, {box.high.x, box.high.y, z_}});
    Functions kept = rbf_narrowed(functions_, cell);
    const Cover cover = rbf_cover(kept, cell);
    if (cover != Cover::kMixed) return {cover, nullptr};
    return {cover, std::make_unique<RbfSection>(std::move(kept), to_model_, z_, outside_)};
  }

 private:
  Functions functions_;
  Affine3 to_model_;
  double z_;
  double outside_;
};

// How far the image of a unit ball reaches along z.
double rise(const Affine3& map) {
  const auto& r = map.rows[2];
  return length(Vec3{r[0], r[1], r[2]});
}

class RbfSolid final : public Solid {
 public:
  RbfSolid(std::shared_ptr<const Functions> functions, const Affine3& map, const Box3& bounds)
      : functions_(std::move(functions)), to_model_(inverse(map)), bounds_(bounds) {
    std::vector<CoordinateRange> heights;
    heights.reserve(functions_->size());
    for (const RbfFunction& f : *functions_) {
      constexpr double kSlack = 1 + 1e-9;  // for the rounding of the map and of its inverse
      const double z = map(f.centre).z, reach = kSlack * rise(map) * f.radius;
      heights.push_back({z - reach, z + reach});
      outside_ = std::max(outside_, f.radius);
    }
    by_z_ = IntervalIndex(heights);
    heights_ = std::move(heights);
  }

  [[nodiscard]] Box3 bounds() const override { return bounds_; }

  [[nodiscard]] std::unique_ptr<Section> section(double z) const override {
    std::vector<std::uint32_t> chosen;
    by_z_.for_each_near(z, [&](std::uint32_t i) {
      if (heights_[i].low <= z && z <= heights_[i].high) chosen.push_back(i);
    });
    std::sort(chosen.begin(), chosen.end());
    Functions functions;
    functions.reserve(chosen.size());
    for (const std::uint32_t i : chosen) functions.push_back((*functions_)[i]);
    return std::make_unique<RbfSection>(std::move(functions), to_model_, z, outside_);
  }

 private:
  std::shared_ptr<const Functions> functions_;
  Affine3 to_model_;
  Box3 bounds_;
  std::vector<CoordinateRange> heights_;
  IntervalIndex by_z_;
  double outside_ = 0;  // f where no support reaches: the largest radius.
};

bool acceptable(const RbfFunction& f) {
  const auto within = [](double value, double most) { return std::abs(value) <= most; };
  const auto coordinate = [&](double c) { return within(c, RbfModel::kCoordinateMax); };
  return coordinate(f.centre.x) && coordinate(f.centre.y) && coordinate(f.centre.z) &&
         f.radius >= RbfModel::kRadiusMin && f.radius <= RbfModel::kCoordinateMax &&
         std::all_of(f.quadric.begin(), f.quadric.end(),
                     [&](double c) { return within(c, RbfModel::kCoefficientMax); });
}

}  // namespace

Result<std::unique_ptr<RbfModel>> RbfModel::of(std::vector<RbfFunction> functions) {
  if (functions.empty()) return fail(ErrorCode::kInput, "has no basis functions");
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (acceptable(functions[i])) continue;
    return fail(ErrorCode::kInput,
                fmt::format("basis function {} is beyond the limits (coordinates to {:g}, radii "
                            "from {:g}, coefficients to {:g}); it is damaged, make it again",
                            i, kCoordinateMax, kRadiusMin, kCoefficientMax));
  }
  return std::unique_ptr<RbfModel>(
      new RbfModel(std::make_shared<const Functions>(std::move(functions))));
}

Box3 RbfModel::bounds_under(const Affine3& map) const {
  return rbf_extent(*functions_, map);
}

std::shared_ptr<const Solid> RbfModel::placed(const Affine3& map) const {
  return std::make_shared<RbfSolid>(functions_, map, bounds_under(map));
}

std::string RbfModel::size_text() const {
  return fmt::format("{} basis functions", functions_->size());
}

}  // namespace slipstick
