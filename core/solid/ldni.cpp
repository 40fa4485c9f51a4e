#include "core/solid/ldni.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

constexpr double kFarthest = 1e9;  // of the origin, in widths as in units
constexpr int kMargin = 2;         // widths left free around a box

Result<void> check(const LdniGrid& grid, const LdniRays& rays, std::size_t axis) {
  const auto wrong = [&](const std::string& what) {
    return fail(ErrorCode::kInput,
                fmt::format("axis {}: {}; make the file again", "xyz"[axis], what));
  };
  if (rays.first.empty() || rays.size() != grid.rays() || rays.first.front() != 0 ||
      rays.first.back() != rays.samples.size() || rays.samples.size() > Ldni::kSamplesMax) {
    return wrong("rays and samples do not match in number");
  }
  if (!std::ranges::is_sorted(rays.first)) return wrong("rays overlap");
  for (std::size_t ray = 0; ray < rays.size(); ++ray) {
    const auto samples = rays.of(ray);
    if (samples.size() % 2 != 0) return wrong(fmt::format("ray {} goes in and not out", ray));
    const auto not_rising = [](const LdniSample& a, const LdniSample& b) {
      return a.depth >= b.depth;
    };
    if (std::ranges::adjacent_find(samples, not_rising) != samples.end()) {
      return wrong(fmt::format("depths do not rise on ray {}", ray));
    }
    if (!samples.empty() && samples.back().depth >= grid.depth_end()) {
      return wrong(fmt::format("ray {} ends beyond the grid", ray));
    }
  }
  return {};
}

}  // namespace

Result<LdniGrid> LdniGrid::of(int resolution, double width, Vec3 origin) {
  if (resolution < kResolutionMin || resolution > kResolutionMax) {
    return fail(ErrorCode::kInput, fmt::format("a resolution of {} rays a side is not in {}..{}",
                                               resolution, kResolutionMin, kResolutionMax));
  }
  const auto is_near = [&](double c) {
    return std::abs(c) <= kFarthest && std::abs(c) / width <= kFarthest;
  };
  if (!(width > 0 && width <= kFarthest) || !is_near(origin.x) || !is_near(origin.y) ||
      !is_near(origin.z)) {
    return fail(ErrorCode::kInput,
                fmt::format("rays {} apart with their origin at {}, {}, {} are no grid", width,
                            origin.x, origin.y, origin.z));
  }
  return LdniGrid(resolution, width, origin);
}

Result<LdniGrid> LdniGrid::around(const Box3& box, int resolution) {
  const int cells = resolution - 1 - 2 * kMargin;
  if (cells < 1) {
    return fail(ErrorCode::kInput, fmt::format("a resolution of {} rays a side is not in {}..{}",
                                               resolution, 2 + 2 * kMargin, kResolutionMax));
  }
  const Vec3 size = box.empty() ? Vec3{} : box.size();
  const double width = std::max({size.x, size.y, size.z}) / cells;
  const double half = 0.5 * (resolution - 1) * width;
  const Vec3 middle = box.empty() ? Vec3{} : box.centre();
  return of(resolution, width, middle - Vec3{half, half, half});
}

Result<void> LdniGrid::check_holds(const Box3& box) const {
  const double reach = (resolution_ - 1) * width_;
  const Box3 all{origin_, origin_ + Vec3{reach, reach, reach}};
  if (box.empty() || box.within(all) == box) return {};
  return fail(
      ErrorCode::kInput,
      fmt::format("reaches from {:g}, {:g}, {:g} to {:g}, {:g}, {:g}, out of the grid of "
                  "rays, which begins at {:g}, {:g}, {:g} and is {:g} long; make that larger",
                  box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z, all.low.x,
                  all.low.y, all.low.z, reach));
}

Result<Ldni> Ldni::of(const LdniGrid& grid, LdniAxes axes) {
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    if (const auto ok = check(grid, axes[axis], axis); !ok) return fail(ok.error());
  }
  return Ldni(grid, std::move(axes));
}

std::size_t Ldni::samples() const {
  std::size_t count = 0;
  for (const LdniRays& rays : axes_) count += rays.samples.size();
  return count;
}

}  // namespace slipstick
