#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace slipstick {

/// 256 bits of chance as hexadecimal digits. \return kUnavailable if the system has none.
[[nodiscard]] Result<std::string> random_key();

/// The key in `path`, made by chance (256 bits, as hexadecimal digits) if there is none yet;
/// readable by its owner only. \return kUnavailable if it can be neither read nor made.
[[nodiscard]] Result<std::string> load_or_make_key(const std::filesystem::path& path);

}  // namespace slipstick
