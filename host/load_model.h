#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/solid/mesh_cut.h"
#include "core/solid/solid.h"

namespace slipstick {

/// What a mesh becomes.
enum class MeshAs : std::uint8_t {
  kMesh,  ///< A solid of its own: exact.
  kLdni,  ///< Layered depth-normal images.
  kBsp,   ///< A partition tree.
};

struct LoadOptions {
  /// The extent of a `.vm` expression in its own units, which has none of its own.
  Box3 bounds{{-1, -1, -1}, {1, 1, 1}};
  MeshAs as = MeshAs::kMesh;
  Winding winding = Winding::kNonzero;  ///< Of a mesh.
  int resolution = 1000;                ///< Rays a side of the images of a mesh.
};

struct LoadedModel {
  std::unique_ptr<Model> model;
  std::string name;     ///< File name without its folder.
  std::string warning;  ///< Empty, or one line: "not closed: …".
};

/// Reads a model of any supported kind, told by its extension.
/// \return kInput with a message that names the file: missing, of unknown kind, no mesh although it
/// is to become something else, or with the loader's reason.
[[nodiscard]] Result<LoadedModel> load_model(const std::filesystem::path& path,
                                             const LoadOptions& options);

}  // namespace slipstick
