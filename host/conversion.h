#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/solid/boolean.h"
#include "host/load_model.h"

namespace slipstick {

/// What `convert` is asked for.
struct ConversionRequest {
  std::filesystem::path model;
  std::filesystem::path output;  ///< Its extension says the representation: .ldni, .bsp or .rbf.
  std::filesystem::path with;    ///< Empty, or a second model, in the same frame.
  Boolean operation = Boolean::kUnion;
  LoadOptions loading;
};

/// A file to be written.
struct Conversion {
  std::string bytes;
  std::string kind;
  std::string size_text;
  std::vector<std::string> warnings;
};

/// From any solid to .ldni (from meshes exactly, from others by sampling; both operands on one
/// grid), from meshes and trees to .bsp, from points with normals and fits to .rbf. \return kInput,
/// naming the file, for what cannot be read or has no way to the representation.
[[nodiscard]] Result<Conversion> convert(const ConversionRequest& request);

}  // namespace slipstick
