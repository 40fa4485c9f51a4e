#include "host/mesh_as.h"

#include <fmt/format.h>

#include <utility>

#include "core/solid/bsp_build.h"

namespace slipstick {
namespace {

std::string warning_of(const LdniMended& mended) {
  if (mended == LdniMended{}) return {};
  return fmt::format("{} rays did not close: {} were taken from their neighbours, {} left empty",
                     mended.copied + mended.lost, mended.copied, mended.lost);
}

}  // namespace

Result<std::unique_ptr<BspModel>> bsp_model(const MeshModel& mesh) {
  auto tree = bsp_of(mesh.mesh());
  if (!tree) return fail(tree.error());
  return BspModel::of(*std::move(tree));
}

Result<LdniLoaded> ldni_model(const MeshModel& mesh, int resolution) {
  const auto grid = LdniGrid::around(mesh.bounds_under({}), resolution);
  if (!grid) return fail(grid.error());
  return ldni_model(mesh, *grid);
}

Result<LdniLoaded> ldni_model(const MeshModel& mesh, const LdniGrid& grid) {
  auto made = ldni_of(mesh, grid);
  if (!made) return fail(made.error());
  return LdniLoaded{std::make_unique<LdniModel>(std::move(made->ldni)), warning_of(made->mended)};
}

}  // namespace slipstick
