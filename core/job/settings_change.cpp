#include "core/job/settings_change.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/job/settings_table_check.h"

namespace slipstick {
namespace {

// What is longer is no number that a setting could have.
constexpr std::size_t kTextSizeMax = 64;
constexpr std::string_view kOfTheFirstLayer[] = {"first_layer_nozzle_celsius",
                                                 "first_layer_bed_celsius",
                                                 "first_layer_line_width",
                                                 "first_layer_speed",
                                                 "skirt_loops",
                                                 "skirt_distance"};
constexpr std::string_view kOfTheSpool[] = {"material_name", "density"};

bool is_among(std::span<const std::string_view> keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

Result<void> change_one(PrintSettings& settings, const std::string& key, const std::string& text) {
  const auto setting = find_setting(key);
  if (!setting) return fail(setting.error());
  const std::string_view why = why_settled(**setting);
  if (!why.empty()) {
    return fail(ErrorCode::kInput, fmt::format("{}: cannot change in a print: {}", key, why));
  }
  if (text.size() > kTextSizeMax) return fail(ErrorCode::kInput, key + ": must be a number");
  return set_from_text(settings, key, text);
}

}  // namespace

std::string_view why_settled(const Setting& setting) {
  if (setting.group == SettingGroup::kPrinter) return "it belongs to the machine";
  if (setting.group == SettingGroup::kSlicing)
    return "lattice, layers, contours and their proofs are settled for the whole of it";
  if (is_among(kOfTheFirstLayer, setting.key)) return "it is for the first layer only";
  if (is_among(kOfTheSpool, setting.key)) return "it belongs to the spool";
  return {};
}

Result<PrintSettings> changed(const PrintSettings& settings, const SettingTexts& values) {
  if (values.empty()) return fail(ErrorCode::kInput, "no setting is named");
  PrintSettings result = settings;
  for (const auto& [key, text] : values) {
    if (const auto ok = change_one(result, key, text); !ok) return fail(ok.error());
  }
  if (const auto ok = validate(result); !ok) return fail(ok.error());
  return result;
}

}  // namespace slipstick
