#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/solid/solid.h"

namespace slipstick {

struct LoadedModel {
  std::unique_ptr<Model> model;
  std::string name;     ///< File name without its folder.
  std::string warning;  ///< Empty, or one line: "not closed: …".
};

/// Reads a model of any supported kind, told by its extension.
///
/// \param bounds the extent of a `.vm` expression in its own units, which has none of its own.
/// \return kInput with a message that names the file: missing, of unknown kind, or with the
/// loader's reason.
[[nodiscard]] Result<LoadedModel> load_model(const std::filesystem::path& path, const Box3& bounds);

}  // namespace slipstick
