#include "host/load_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "core/formats/bsp_file.h"
#include "core/formats/lda_file.h"
#include "core/formats/ldni_file.h"
#include "core/formats/lua_script.h"
#include "core/formats/point_cloud.h"
#include "core/formats/rbf_file.h"
#include "core/formats/vm_text.h"
#include "core/solid/mesh_model.h"
#include "core/solid/rbf_fit.h"
#include "host/atomic_file.h"
#include "host/mesh_as.h"

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

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}

Result<LoadedModel> with_warning(Result<std::unique_ptr<Model>> model, std::string name,
                                 std::string warning) {
  if (!model) return fail(model.error().within(name));
  return LoadedModel{std::move(*model), std::move(name), std::move(warning)};
}

Result<LoadedModel> load_mesh(std::string_view bytes, const std::string& name,
                              const LoadOptions& options) {
  auto mesh = load_mesh_model(bytes, name, options.winding);
  if (!mesh) return fail(mesh.error());
  std::string warning = (*mesh)->warning();
  switch (options.as) {
    case MeshAs::kMesh:
      return LoadedModel{std::move(*mesh), name, std::move(warning)};
    case MeshAs::kBsp:
      return with_warning(bsp_model(**mesh), name, std::move(warning));
    case MeshAs::kLdni:
      break;
  }
  auto made = ldni_around(**mesh, options.resolution);
  if (!made) return fail(made.error().within(name));
  return LoadedModel{std::make_unique<LdniModel>(std::move(made->ldni)), name,
                     joined(warning, warning_of(made->mended))};
}

bool is_one_of(std::string_view kind, std::initializer_list<std::string_view> kinds) {
  return std::ranges::find(kinds, kind) != kinds.end();
}

}  // namespace

Result<LoadedModel> load_model(const std::filesystem::path& path, const LoadOptions& options) {
  const std::string kind = lower(path.extension().string());
  const std::string name = path.filename().string();
  bool is_mesh = is_one_of(kind, {".stl", ".obj", ".ply", ".off", ".3mf"});
  const bool is_points = is_one_of(kind, {".xyz", ".pwn"});
  if (!is_mesh && !is_points &&
      !is_one_of(kind, {".lua", ".vm", ".ldni", ".lda", ".bsp", ".rbf"})) {
    return fail(ErrorCode::kInput,
                fmt::format("{}: unknown kind of model; .lua, .vm, .ldni, .lda, .bsp, .rbf, .stl, "
                            ".obj, .ply, .off, .3mf, .xyz and .pwn can be read",
                            path.string()));
  }
  const auto bytes = read_file(path);
  if (!bytes) return fail(bytes.error());
  const bool is_cloud = is_points || (kind == ".ply" && ply_is_point_cloud(*bytes));
  is_mesh = is_mesh && !is_cloud;
  if (!is_mesh && options.as != MeshAs::kMesh) {
    return fail(ErrorCode::kInput, fmt::format("{}: is no mesh, which alone --as is for; leave it "
                                               "out, or convert the model first",
                                               name));
  }
  if (is_mesh) return load_mesh(*bytes, name, options);
  if (is_cloud) return loaded(load_point_model(*bytes, name), name);
  if (kind == ".lua") return loaded(load_lua_model(*bytes, name), name);
  if (kind == ".vm") return loaded(load_vm_model(*bytes, name, options.bounds), name);
  if (kind == ".ldni") return loaded(load_ldni_model(*bytes, name), name);
  if (kind == ".lda") return loaded(load_lda_model(*bytes, name), name);
  if (kind == ".bsp") return loaded(load_bsp_model(*bytes, name), name);
  return loaded(load_rbf_model(*bytes, name), name);
}

}  // namespace slipstick
