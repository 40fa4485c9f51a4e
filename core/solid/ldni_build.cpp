#include "core/solid/ldni_build.h"

#include <utility>

#include "core/solid/ldni_settle.h"
#include "core/solid/ldni_sweep.h"

namespace slipstick {
Result<LdniOfMesh> ldni_of(const MeshModel& mesh, const LdniGrid& grid) {
  if (const auto ok = grid.check_holds(mesh.bounds_under({})); !ok) return fail(ok.error());
  LdniAxes axes;
  LdniMended mended;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    LdniSwept sweep = swept(mesh, grid, axis);
    const LdniMended here = mend(sweep.rays, grid, sweep.open);
    mended.copied += here.copied;
    mended.lost += here.lost;
    axes[axis] = settled(sweep.rays, grid, axis);
  }
  auto ldni = Ldni::of(grid, std::move(axes));
  if (!ldni) return fail(ldni.error());
  return LdniOfMesh{*std::move(ldni), mended};
}

}  // namespace slipstick
