#include "core/formats/mesh.h"

#include <fmt/format.h>

#include <string>

#include "core/formats/mesh_3mf.h"
#include "core/formats/mesh_assimp.h"
#include "core/formats/mesh_build.h"
#include "core/formats/mesh_obj.h"
#include "core/formats/mesh_off.h"
#include "core/formats/mesh_ply.h"

namespace slipstick {
namespace {

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

Result<TriangleMesh> read_raw(std::string_view bytes, const std::string& extension) {
  if (extension == "ply") return read_ply(bytes);
  if (extension == "off") return read_off(bytes);
  if (extension == "3mf") return read_3mf(bytes);
  if (extension == "obj") return read_obj(bytes);
  if (extension == "stl") return read_with_assimp(bytes, extension);
  return fail(ErrorCode::kInput,
              fmt::format("\"{}\" is no mesh format; use stl, obj, ply, off or 3mf", extension));
}

}  // namespace

Result<TriangleMesh> read_mesh(std::string_view bytes, std::string_view extension) {
  if (bytes.size() > kMeshBytesMax) {
    return fail(ErrorCode::kInput,
                fmt::format("has {} bytes, at most {} are read; simplify the mesh", bytes.size(),
                            kMeshBytesMax));
  }
  const auto raw = read_raw(bytes, lower_case(extension));
  if (!raw) return fail(raw.error());
  if (raw->vertices.size() > kMeshElementsMax || raw->triangles.size() > kMeshElementsMax) {
    return fail(ErrorCode::kInput,
                fmt::format("has {} vertices and {} triangles, at most {} are read; simplify it",
                            raw->vertices.size(), raw->triangles.size(), kMeshElementsMax));
  }
  return cleaned(*raw);
}

}  // namespace slipstick
