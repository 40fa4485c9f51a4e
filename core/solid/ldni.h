#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/box.h"
#include "core/base/result.h"
#include "core/solid/ldni_normal.h"

namespace slipstick {

/// \file
/// Layered depth-normal images (paper, section 3.1 and reference 3): a solid as what three sets of
/// rays, each along one axis, see of it.

/// Where the rays run. Axes count cyclically: ray (i, j) of axis a stands at i widths along axis
/// a + 1 and at j along axis a + 2, seen from the origin. Depth is counted from the origin as well,
/// in `kUnits` parts of a width, so that it is an integer.
class LdniGrid {
 public:
  static constexpr int kResolutionMax = 4095;
  static constexpr int kResolutionMin = 2;
  static constexpr std::uint32_t kUnits = std::uint32_t{1} << 20;

  /// \return kInput if a number is out of range or not finite.
  [[nodiscard]] static Result<LdniGrid> of(int resolution, double width, Vec3 origin);

  /// The grid whose rays cover `box` and two widths around it, its middle in the box's.
  /// \return kInput if the box is a point or empty, or `resolution` is out of range.
  [[nodiscard]] static Result<LdniGrid> around(const Box3& box, int resolution);

  /// \return kInput, with the sizes, if `box` reaches beyond the outermost rays.
  [[nodiscard]] Result<void> check_holds(const Box3& box) const;

  /// Rays a side.
  [[nodiscard]] int resolution() const { return resolution_; }
  [[nodiscard]] std::size_t rays() const {
    return static_cast<std::size_t>(resolution_) * static_cast<std::size_t>(resolution_);
  }
  [[nodiscard]] std::size_t ray(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(resolution_) +
           static_cast<std::size_t>(i);
  }
  /// Between rays, in the model's units.
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] Vec3 origin() const { return origin_; }
  /// One more than the largest depth.
  [[nodiscard]] std::uint64_t depth_end() const { return std::uint64_t{kUnits} * reach(); }

  friend bool operator==(const LdniGrid&, const LdniGrid&) = default;

 private:
  LdniGrid(int resolution, double width, Vec3 origin)
      : resolution_(resolution), width_(width), origin_(origin) {}
  [[nodiscard]] std::uint32_t reach() const { return static_cast<std::uint32_t>(resolution_); }

  int resolution_;
  double width_;
  Vec3 origin_;
};

/// Where a ray passes the surface.
struct LdniSample {
  std::uint32_t depth;
  LdniNormal normal;

  friend bool operator==(const LdniSample&, const LdniSample&) = default;
};

/// The samples of one axis, ray after ray.
struct LdniRays {
  std::vector<std::uint32_t> first{0};  ///< Of each ray in `samples`, and their end.
  std::vector<LdniSample> samples;

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const LdniSample> of(std::size_t ray) const {
    return std::span(samples).subspan(first[ray], first[ray + 1] - first[ray]);
  }
  /// Ends the ray that was being added to.
  void end_ray() { first.push_back(static_cast<std::uint32_t>(samples.size())); }

  friend bool operator==(const LdniRays&, const LdniRays&) = default;
};

using LdniAxes = std::array<LdniRays, 3>;

/// Images that can be true: on each ray the depths rise, and as many samples go in as come out.
class Ldni {
 public:
  /// So many samples an axis: half a gigabyte.
  static constexpr std::size_t kSamplesMax = std::size_t{1} << 26;

  /// \return kInput if the rays are not those of the grid or break what an `Ldni` promises; the
  /// message says which.
  [[nodiscard]] static Result<Ldni> of(const LdniGrid& grid, LdniAxes axes);

  [[nodiscard]] const LdniGrid& grid() const { return grid_; }
  [[nodiscard]] const LdniAxes& axes() const { return axes_; }
  [[nodiscard]] std::size_t samples() const;

  friend bool operator==(const Ldni&, const Ldni&) = default;

 private:
  Ldni(const LdniGrid& grid, LdniAxes axes) : grid_(grid), axes_(std::move(axes)) {}

  LdniGrid grid_;
  LdniAxes axes_;
};

}  // namespace slipstick
