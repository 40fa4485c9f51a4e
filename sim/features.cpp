#include "sim/features.h"

#include <algorithm>
#include <array>

namespace slipstick {

namespace {

struct Row {
  Feature feature;
  std::string_view name;
  std::string_view capabilities;  ///< That M115 shows for it, each between commas.
};

constexpr std::array kRows = std::to_array<Row>({
    {Feature::kAdvancedOk, "advanced-ok", ""},
    {Feature::kBedLeveling, "bed-leveling", ",AUTOLEVEL,Z_PROBE,LEVELING_DATA,"},
    {Feature::kEeprom, "eeprom", ",EEPROM,"},
    {Feature::kEmergencyParser, "emergency-parser", ",EMERGENCY_PARSER,"},
    {Feature::kFilamentChange, "filament-change", ""},
    {Feature::kFilamentSensor, "filament-sensor", ",RUNOUT,"},
    {Feature::kHostPrompts, "host-prompts", ",HOST_ACTION_COMMANDS,PROMPT_SUPPORT,"},
    {Feature::kLinearAdvance, "linear-advance", ""},
    {Feature::kMeatPack, "meatpack", ",MEATPACK,"},
    {Feature::kPositionReports, "position-reports", ",AUTOREPORT_POS,"},
    {Feature::kProgress, "progress", ",BUILD_PERCENT,"},
    {Feature::kSdCard, "sd-card", ",SDCARD,SD_WRITE,"},
});

}  // namespace

std::optional<Feature> find_feature(std::string_view name) {
  const auto* row = std::ranges::find(kRows, name, &Row::name);
  if (row == kRows.end()) return std::nullopt;
  return row->feature;
}

std::string feature_names() {
  std::string names;
  for (const Row& row : kRows) names.append(names.empty() ? "" : ", ").append(row.name);
  return names;
}

std::string capability_with(const Features& features, std::string_view capability) {
  const std::string name(capability.substr(0, capability.find(':')));
  const bool on = std::ranges::any_of(kRows, [&](const Row& row) {
    return features.has(row.feature) &&
           row.capabilities.find("," + name + ",") != std::string_view::npos;
  });
  return on ? name + ":1" : std::string(capability);
}

}  // namespace slipstick
