#pragma once

#include <string>

#include "core/job/settings_table.h"

namespace slipstick {

/// One group as a TOML file that sets what `settings` has, each key below a comment with its help.
[[nodiscard]] std::string commented_toml(const PrintSettings& settings, SettingGroup group);

/// All settings in Markdown: docs/SETTINGS.md.
[[nodiscard]] std::string settings_reference();

}  // namespace slipstick
