#include "host/load_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/formats/lua_script.h"
#include "core/formats/vm_text.h"
#include "core/solid/mesh_model.h"
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
  const bool is_mesh = kind == ".stl" || kind == ".obj" || kind == ".ply" || kind == ".off";
  if (!is_mesh && kind != ".lua" && kind != ".vm") {
    return fail(ErrorCode::kInput, fmt::format("{}: unknown kind of model; .lua, .vm, .stl, .obj, "
                                               ".ply and .off can be read",
                                               path.string()));
  }
  const auto bytes = read_file(path);
  if (!bytes) return fail(bytes.error());
  if (kind == ".lua") return loaded(load_lua_model(*bytes, name), name);
  if (kind == ".vm") return loaded(load_vm_model(*bytes, name, bounds), name);
  auto mesh = load_mesh_model(*bytes, name);
  if (!mesh) return fail(mesh.error());
  std::string warning = (*mesh)->warning();
  return LoadedModel{std::move(*mesh), name, std::move(warning)};
}

}  // namespace slipstick
