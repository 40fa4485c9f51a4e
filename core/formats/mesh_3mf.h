#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/result.h"
#include "core/formats/mesh.h"

namespace slipstick {

/// Limits of a 3MF file beside those of all meshes.
inline constexpr std::size_t k3mfUnpackedMax = std::size_t{1} << 30;  ///< Bytes of all parts.
inline constexpr std::size_t k3mfPartsMax = 1024;  ///< Model parts that are read.
inline constexpr std::size_t k3mfDepthMax = 16;    ///< Objects within objects.
inline constexpr std::size_t k3mfInstancesMax = std::size_t{1} << 16;  ///< Objects placed.

/// Reads what a 3MF file wants built, in millimetres: every item of its build, with the objects it
/// consists of, moved as their transforms say (a mirrored one keeps its outside outside). Objects
/// that are not in the build, items with `printable="0"` and objects of another type than `model`
/// (supports, modifiers) are left out. Parts that items and components point to by `p:path` (the
/// production extension) are read; colours and materials are ignored; a file that requires any
/// other extension is refused.
///
/// Our own on libzip and expat: of the readers in Debian 12, assimp ignores units, follows cycles
/// of components to its end and keeps coordinates as floats, and none bounds what is unpacked.
///
/// \return kInput: no zip file, no model part, bad XML (with its part and line), beyond a limit, an
/// index or object that does not exist, an object within itself, a transform that flattens, nothing
/// to be built. Coordinates may be larger than `kMeshCoordinateMax`, vertices double.
[[nodiscard]] Result<TriangleMesh> read_3mf(std::string_view bytes);

}  // namespace slipstick
