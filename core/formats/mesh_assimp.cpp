#include "core/formats/mesh_assimp.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <exception>
#include <memory>

#include "core/formats/mesh_build.h"

namespace slipstick {
namespace {

// There are no other files.
class NoFiles final : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream* stream) override { delete stream; }
};

// assimp takes such a file for text even if it is binary STL, and reads beyond it (its issue 6877).
bool begins_with_byte_order_mark(std::string_view bytes) {
  return bytes.starts_with("\xEF\xBB\xBF") || bytes.starts_with("\xFE\xFF") ||
         bytes.starts_with("\xFF\xFE");
}

void append(TriangleMesh& mesh, const aiMesh& part) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& p = part.mVertices[i];
    mesh.vertices.push_back({double{p.x}, double{p.y}, double{p.z}});
  }
  std::vector<std::uint32_t> corners;
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    corners.clear();
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      const std::uint32_t index = face.mIndices[k];
      corners.push_back(index < part.mNumVertices ? first + index : to_vertex_index(-1));
    }
    add_polygon(mesh, corners);
  }
}

}  // namespace

Result<TriangleMesh> read_with_assimp(std::string_view bytes, const std::string& extension) {
  if (begins_with_byte_order_mark(bytes)) {
    return fail(ErrorCode::kInput, "begins with a byte order mark; save it without one");
  }
  try {
    Assimp::Importer importer;
    importer.SetIOHandler(std::make_unique<NoFiles>().release());
    const aiScene* scene =
        importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, extension.c_str());
    if (scene == nullptr) {
      return fail(ErrorCode::kInput, fmt::format("is not readable as {}: {}; export it again",
                                                 extension, importer.GetErrorString()));
    }
    TriangleMesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(mesh, *scene->mMeshes[i]);
    return mesh;
  } catch (const std::exception& error) {
    return fail(ErrorCode::kInput,
                fmt::format("is not readable as {}: {}; export it again", extension, error.what()));
  }
}

}  // namespace slipstick
