#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/job/settings_table.h"

namespace slipstick {

/// \file
/// Settings that change in the middle of a print: the layers below keep what they were made with.

/// Values by key, as text.
using SettingTexts = std::map<std::string, std::string>;

/// From which layer on other values hold.
struct SettingsChange {
  int from_layer = 0;
  SettingTexts values;

  friend bool operator==(const SettingsChange&, const SettingsChange&) = default;
};

/// Why a print under way cannot have another value of it; empty: it can.
[[nodiscard]] std::string_view why_settled(const Setting& setting);

/// `settings` with other `values`, for layers that are still to be made.
/// \return kInput for none at all, an unknown key, a bad value, a setting that is settled, or one
/// that does not suit the others: "key: what is wrong".
[[nodiscard]] Result<PrintSettings> changed(const PrintSettings& settings,
                                            const SettingTexts& values);

}  // namespace slipstick
