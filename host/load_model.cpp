#include "host/load_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/formats/bsp_file.h"
#include "core/formats/lua_script.h"
#include "core/formats/point_cloud.h"
#include "core/formats/rbf_file.h"
#include "core/formats/vm_text.h"
#include "core/solid/mesh_model.h"
#include "core/solid/rbf_fit.h"
#include "host/atomic_file.h"

namespace slipstick {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

Result<LoadedModel> loaded(Result<std::unique_ptr<Model>> model, std::string name) {
  if (!model) return fail(model.error());
  return LoadedModel{std::move(*model), std::move(name), {}};
}

}  // namespace

Result<LoadedModel> load_model(const std::filesystem::path& path, const Box3& bounds) {
  const std::string kind = lower(path.extension().string());
  const std::string name = path.filename().string();
  const bool is_mesh =
      kind == ".stl" || kind == ".obj" || kind == ".ply" || kind == ".off" || kind == ".3mf";
  const bool is_points = kind == ".xyz" || kind == ".pwn";
  if (!is_mesh && !is_points && kind != ".lua" && kind != ".vm" && kind != ".bsp" &&
      kind != ".rbf") {
    return fail(ErrorCode::kInput,
                fmt::format("{}: unknown kind of model; .lua, .vm, .bsp, .rbf, "
                            ".stl, .obj, .ply, .off, .3mf, .xyz and .pwn can be read",
                            path.string()));
  }
  const auto bytes = read_file(path);
  if (!bytes) return fail(bytes.error());
  if (kind == ".lua") return loaded(load_lua_model(*bytes, name), name);
  if (kind == ".vm") return loaded(load_vm_model(*bytes, name, bounds), name);
  if (kind == ".bsp") return loaded(load_bsp_model(*bytes, name), name);
  if (kind == ".rbf") return loaded(load_rbf_model(*bytes, name), name);
  if (is_points || (kind == ".ply" && ply_is_point_cloud(*bytes))) {
    return loaded(load_point_model(*bytes, name), name);
  }
  auto mesh = load_mesh_model(*bytes, name);
  if (!mesh) return fail(mesh.error());
  std::string warning = (*mesh)->warning();
  return LoadedModel{std::move(*mesh), name, std::move(warning)};
}

}  // namespace slipstick
