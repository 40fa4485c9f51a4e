#include "core/solid/rbf_field.h"

#include <algorithm>
#include <iterator>

namespace slipstick {
namespace {

// Distances and weights round by a few units in the last place, and a sum of up to a thousand terms
// by less than this share of their sizes.
constexpr double kRounding = 1e-12;
// The smallest weight that is not zero is above 10^-65; a value above this is positive even so.
constexpr double kPositive = 1e-200;

struct Sums {
  double weighted = 0;
  double weights = 0;
};

Sums sums_at(std::span<const RbfFunction> functions, Vec3 p) {
  Sums sums;
  for (const RbfFunction& f : functions) {
    const Vec3 d = p - f.centre;
    const double square = dot(d, d);
    if (!(square < f.radius * f.radius)) continue;
    const double weight = wendland(square, f.radius);
    sums.weighted += weight * quadric_at(f.quadric, d);
    sums.weights += weight;
  }
  return sums;
}

// Half the extent of an interval and what its middle and its ends may have been rounded by.
double half_of(double low, double high) {
  return (0.5 + kRounding) * (high - low) + 0x1p-51 * (std::abs(low) + std::abs(high));
}

RbfRange range_over(const RbfFunction& f, const Box3& box) {
  return quadric_range(f.quadric, box.centre() - f.centre,
                       {half_of(box.low.x, box.high.x), half_of(box.low.y, box.high.y),
                        half_of(box.low.z, box.high.z)});
}

// Of the weight, which falls with the distance.
RbfRange weight_range(const RbfFunction& f, const Box3& box) {
  const auto weight = [&](double square) {
    return square < f.radius * f.radius ? wendland(square, f.radius) : 0;
  };
  return {(1 - kRounding) * weight(farthest_square(box, f.centre) * (1 + kRounding)),
          (1 + kRounding) * weight(nearest_square(box, f.centre) * (1 - kRounding))};
}

// Bounds of the weighted sum, and of what adding it up rounds by.
struct SumRange {
  double low = 0;
  double high = 0;
  double size = 0;

  void add(const RbfRange& value, const RbfRange& weight) {
    low += value.low * (value.low < 0 ? weight.high : weight.low);
    high += value.high * (value.high < 0 ? weight.low : weight.high);
    size += std::max(std::abs(value.low), std::abs(value.high)) * weight.high;
  }
  [[nodiscard]] bool surely_positive() const { return low > kRounding * size + kPositive; }
  [[nodiscard]] bool surely_negative() const { return high < -kRounding * size - kPositive; }
};

}  // namespace

std::optional<double> rbf_value(std::span<const RbfFunction> functions, Vec3 p) {
  const Sums sums = sums_at(functions, p);
  if (!(sums.weights > 0)) return {};
  return sums.weighted / sums.weights;
}

bool rbf_inside(std::span<const RbfFunction> functions, Vec3 p) {
  const Sums sums = sums_at(functions, p);
  return sums.weights > 0 && sums.weighted / sums.weights <= 0;
}

bool rbf_touches(const RbfFunction& f, const Box3& box) {
  return nearest_square(box, f.centre) * (1 - kRounding) < f.radius * f.radius;
}

Cover rbf_cover(std::span<const RbfFunction> functions, const Box3& box) {
  SumRange sum;
  bool all_positive = true;
  bool held = false;
  for (const RbfFunction& f : functions) {
    const RbfRange range = range_over(f, box);
    sum.add(range, weight_range(f, box));
    all_positive = all_positive && range.low > kPositive;
    held = held || farthest_square(box, f.centre) * (1 + kRounding) < f.radius * f.radius;
  }
  if (all_positive || sum.surely_positive()) return Cover::kOutside;
  return held && sum.surely_negative() ? Cover::kInside : Cover::kMixed;
}

std::vector<RbfFunction> rbf_narrowed(std::span<const RbfFunction> functions, const Box3& box) {
  std::vector<RbfFunction> kept;
  std::copy_if(functions.begin(), functions.end(), std::back_inserter(kept),
               [&](const RbfFunction& f) { return rbf_touches(f, box); });
  return kept;
}

}  // namespace slipstick
