#include "core/solid/ldni_sample.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "core/contour/place_roots.h"
#include "core/contour/trace.h"
#include "core/image/sample.h"
#include "core/solid/ldni_settle.h"

namespace slipstick {
namespace {

constexpr double kCell = 0.125;  // mm a width, in the frame that is sliced: any binary number does

// The frame in which the rays of an axis run along x, with rows along y and planes along z.
Affine3 along_x(const LdniGrid& grid, std::size_t axis) {
  const double cells = kCell / grid.width();
  const Vec3 o = grid.origin();
  const Affine3 to_cells =
      composed(scaling({cells, cells, cells}), translation({-o.x, -o.y, -o.z}));
  Affine3 turn{};
  for (std::size_t k = 0; k < 3; ++k) {
    turn.rows[k] = {0, 0, 0, 0};
    turn.rows[k][(axis + k) % 3] = 1;
  }
  return composed(turn, to_cells);
}

struct Crossing {
  int row;
  std::uint32_t depth;
};

class AxisSampler {
 public:
  AxisSampler(const Model& model, const LdniGrid& grid, std::size_t axis)
      : grid_(grid), solid_(model.placed(along_x(grid, axis))) {}

  Result<LdniRays> run() {
    const double reach = (grid_.resolution() - 1) * kCell;
    const auto lattice = SliceGrid::over({{0, 0}, {reach, reach}}, kCell);
    if (!lattice) return fail(lattice.error());
    for (int plane = 0; plane < grid_.resolution(); ++plane) {
      const auto section = solid_->section(plane * kCell);
      const auto image = sample(*section, *lattice);
      if (!image) return fail(image.error());
      ContourSet contours = trace(*image, Ambiguity::kSolid);
      place_roots(contours, *section);
      take(contours);
    }
    return std::move(rays_);
  }

 private:
  void take(const ContourSet& contours) {
    constexpr auto kPerPlace = LdniGrid::kUnits / SliceGrid::kUnitsPerCell;
    const SliceGrid& lattice = contours.grid();
    crossings_.clear();
    for (std::size_t i = 0; i < contours.sticks().size(); ++i) {
      const Stick stick = contours.sticks()[i];
      if (step(stick.outward).x == 0) continue;
      const std::int64_t units = position(stick, contours.places()[i]).x +
                                 lattice.first_column() * SliceGrid::kUnitsPerCell;
      crossings_.push_back({static_cast<int>(stick.row + lattice.first_row()),
                            static_cast<std::uint32_t>(units * kPerPlace)});
    }
    std::ranges::sort(crossings_, {}, [](const Crossing& c) { return std::pair(c.row, c.depth); });
    auto next = crossings_.begin();
    for (int row = 0; row < grid_.resolution(); ++row) {
      for (; next != crossings_.end() && next->row == row; ++next) {
        rays_.samples.push_back({next->depth, {}});
      }
      rays_.end_ray();
    }
  }

  const LdniGrid& grid_;
  std::shared_ptr<const Solid> solid_;
  LdniRays rays_;
  std::vector<Crossing> crossings_;
};

}  // namespace

Result<Ldni> ldni_by_sampling(const Model& model, const LdniGrid& grid) {
  if (const auto ok = grid.check_holds(model.bounds_under({})); !ok) return fail(ok.error());
  LdniAxes axes;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    auto rays = AxisSampler(model, grid, axis).run();
    if (!rays) return fail(rays.error());
    axes[axis] = settled(with_normals_of_differences(*rays, grid, axis), grid, axis);
  }
  return Ldni::of(grid, std::move(axes));
}

}  // namespace slipstick
