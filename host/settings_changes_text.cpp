#include "host/settings_changes_text.h"

#include <nlohmann/json.hpp>

namespace slipstick {
namespace {

using Json = nlohmann::json;

Json to_json(const SettingsChange& change) {
  return {{"from_layer", change.from_layer}, {"settings", change.values}};
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::optional<SettingsChange> change_of(const Json& json) {
  if (!json.is_object() || json.size() != 2) return {};
  const auto layer = json.find("from_layer");
  const auto values = json.find("settings");
  if (layer == json.end() || !layer->is_number_integer() || values == json.end()) return {};
  if (!values->is_object()) return {};
  constexpr std::int64_t kLayersMax = 1'000'000;
  const auto from = layer->get<std::int64_t>();
  if (from < 0 || from > kLayersMax) return {};
  SettingsChange change{static_cast<int>(from), {}};
  for (const auto& [key, value] : values->items()) {
    if (!value.is_string()) return {};
    change.values.emplace(key, value.get<std::string>());
  }
  return change;
}

}  // namespace

std::string change_text(const SettingsChange& change) {
  return text_of(to_json(change));
}

std::optional<SettingsChange> parse_change(std::string_view text) {
  return change_of(Json::parse(text, nullptr, false));
}

std::string changes_text(const std::vector<SettingsChange>& changes) {
  Json all = Json::array();
  for (const SettingsChange& change : changes) all.push_back(to_json(change));
  return text_of(all);
}

std::optional<std::vector<SettingsChange>> parse_changes(std::string_view text) {
  std::vector<SettingsChange> changes;
  if (text.empty()) return changes;
  const Json all = Json::parse(text, nullptr, false);
  if (!all.is_array()) return {};
  for (const Json& json : all) {
    auto change = change_of(json);
    if (!change) return {};
    changes.push_back(*std::move(change));
  }
  return changes;
}

}  // namespace slipstick
