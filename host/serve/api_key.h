#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace slipstick {

/// The secret in `path`, made by `make` if there is none yet; readable by its owner only.
/// \return kUnavailable if it can be neither read nor made, or has fewer than `least` bytes.
[[nodiscard]] Result<std::string> load_or_make_secret(const std::filesystem::path& path,
                                                      std::size_t least,
                                                      const std::function<std::string()>& make);

/// The key in `path`, by chance (256 bits, as hexadecimal digits) if there is none yet.
[[nodiscard]] Result<std::string> load_or_make_key(const std::filesystem::path& path);

}  // namespace slipstick
