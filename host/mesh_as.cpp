#include "host/mesh_as.h"

#include <fmt/format.h>

#include <utility>

#include "core/solid/bsp_build.h"

namespace slipstick {

std::string warning_of(const LdniMended& mended) {
  if (mended == LdniMended{}) return {};
  return fmt::format("{} rays did not close: {} were taken from their neighbours, {} left empty",
                     mended.copied + mended.lost, mended.copied, mended.lost);
}

Result<std::unique_ptr<BspModel>> bsp_model(const MeshModel& mesh) {
  auto tree = bsp_of(mesh.mesh());
  if (!tree) return fail(tree.error());
  return BspModel::of(*std::move(tree));
}

Result<LdniOfMesh> ldni_around(const MeshModel& mesh, int resolution) {
  const auto grid = LdniGrid::around(mesh.bounds_under({}), resolution);
  if (!grid) return fail(grid.error());
  return ldni_of(mesh, *grid);
}

}  // namespace slipstick
