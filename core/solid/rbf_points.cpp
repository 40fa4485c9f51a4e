#include "core/solid/rbf_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/check.h"

namespace slipstick {
namespace {

constexpr double kCellsPerPoint = 8;

}  // namespace

PointIndex::PointIndex(std::span<const Vec3> points) : points_(points) {
  SLIPSTICK_CHECK(!points.empty() && points.size() < std::numeric_limits<std::uint32_t>::max());
  for (const Vec3 p : points) box_ = box_.with(p);
  const Vec3 size = box_.size();
  const double longest = std::max({size.x, size.y, size.z});
  SLIPSTICK_CHECK(longest > 0);
  const double most = kCellsPerPoint * static_cast<double>(points.size());
  // The finest power of 2^-1/4 of which there are not too many.
  const auto along = [&](double length) { return std::floor(length / size_) + 1; };
  size_ = longest;
  while (true) {
    const double cells = along(size.x) * along(size.y) * along(size.z);
    if (cells > most) break;
    cells_ = {static_cast<int>(along(size.x)), static_cast<int>(along(size.y)),
              static_cast<int>(along(size.z))};
    size_ *= 0.84;
  }
  size_ /= 0.84;

  offsets_.assign(number_of({cells_.x - 1, cells_.y - 1, cells_.z - 1}) + 2, 0);
  for (const Vec3 p : points) ++offsets_[number_of(cell_of(p)) + 1];
  for (std::size_t c = 1; c < offsets_.size(); ++c) offsets_[c] += offsets_[c - 1];
  std::vector<std::uint32_t> next = offsets_;
  items_.resize(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    items_[next[number_of(cell_of(points[i]))]++] = i;
  }
}

PointIndex::Cell PointIndex::cell_of(Vec3 p) const {
  const auto along = [&](double at, double low, int count) {
    return static_cast<int>(std::clamp(std::floor((at - low) / size_), 0.0, count - 1.0));
  };
  return {along(p.x, box_.low.x, cells_.x), along(p.y, box_.low.y, cells_.y),
          along(p.z, box_.low.z, cells_.z)};
}

PointIndex::Nearest PointIndex::nearest(Vec3 p) const {
  Nearest best{0, std::numeric_limits<double>::infinity()};
  const auto nearer = [&](std::uint32_t i, double square) {
    if (square < best.distance) best = {i, square};
  };
  const double farthest = length(box_.size()) + length(p - box_.centre());
  for (double radius = size_; std::isinf(best.distance); radius *= 2) {
    for_each_within(p, radius, nearer);
    if (radius > 2 * farthest) break;
  }
  SLIPSTICK_CHECK(std::isfinite(best.distance));
  return {best.index, std::sqrt(best.distance)};
}

double PointIndex::reach_of(Vec3 p, std::size_t count) const {
  std::vector<double> squares;
  const double farthest = length(box_.size()) + length(p - box_.centre());
  for (double radius = size_; squares.size() < count && radius <= 4 * farthest; radius *= 2) {
    squares.clear();
    for_each_within(p, radius, [&](std::uint32_t, double square) { squares.push_back(square); });
  }
  SLIPSTICK_CHECK(squares.size() >= count);
  const auto kth = squares.begin() + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(squares.begin(), kth, squares.end());
  return std::sqrt(*kth);
}

}  // namespace slipstick
