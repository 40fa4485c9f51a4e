#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/job/settings.h"
#include "core/job/settings_table.h"

namespace slipstick {

/// Applies the TOML text of `file` (its name, for messages) to `settings`; only keys of `allowed`
/// groups. \return kInput: "file:line: key: what is wrong"; `settings` may then be half set.
[[nodiscard]] Result<void> apply_toml(PrintSettings& settings, std::string_view text,
                                      std::string_view file, std::span<const SettingGroup> allowed);

}  // namespace slipstick
