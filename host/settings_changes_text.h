#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/job/settings_change.h"

namespace slipstick {

/// \file
/// Changes of settings as JSON on one line:
///
///     {"from_layer": 12, "settings": {"infill_density": "0.4"}}
///
/// Values are texts as they were given, so that they are read as the very same numbers.

[[nodiscard]] std::string change_text(const SettingsChange& change);
/// \return nothing if `text` is none.
[[nodiscard]] std::optional<SettingsChange> parse_change(std::string_view text);

/// Several, as an array.
[[nodiscard]] std::string changes_text(const std::vector<SettingsChange>& changes);
/// Empty text is none at all. \return nothing if `text` is not changes.
[[nodiscard]] std::optional<std::vector<SettingsChange>> parse_changes(std::string_view text);

}  // namespace slipstick
