#include "host/config_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <optional>

namespace slipstick {
namespace {

tl::unexpected<Error> at_line(std::string_view file, const toml::source_region& source,
                              std::string_view what) {
  return fail(ErrorCode::kInput, fmt::format("{}:{}: {}", file, source.begin.line, what));
}

std::optional<SettingValue> value_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return SettingValue(text->get());
  if (node.is_number()) return SettingValue(*node.value<double>());
  return {};
}

Result<void> apply(PrintSettings& settings, std::string_view key, const toml::node& node,
                   std::span<const SettingGroup> allowed) {
  const auto setting = find_setting(key);
  if (!setting) return fail(setting.error());
  const SettingGroup group = (*setting)->group;
  if (std::find(allowed.begin(), allowed.end(), group) == allowed.end()) {
    return fail(ErrorCode::kInput, fmt::format("{}: is a {} setting and cannot stand in this kind "
                                               "of file",
                                               key, name_of(group)));
  }
  const auto value = value_of(node);
  if (!value) return fail(ErrorCode::kInput, fmt::format("{}: must be a number or text", key));
  return set_value(settings, **setting, *value);
}

// Keys in the order of the file, so that the first mistake is reported first.
Result<void> apply(PrintSettings& settings, const toml::table& table, std::string_view file,
                   std::span<const SettingGroup> allowed) {
  struct Entry {
    const toml::key* key;
    const toml::node* node;
  };
  std::vector<Entry> entries;
  for (const auto& [key, node] : table) entries.push_back({&key, &node});
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.key->source().begin.line < b.key->source().begin.line;
  });
  for (const auto& [key, node] : entries) {
    const auto applied = apply(settings, key->str(), *node, allowed);
    if (!applied) return at_line(file, key->source(), applied.error().message);
  }
  return {};
}

}  // namespace

Result<void> apply_toml(PrintSettings& settings, std::string_view text, std::string_view file,
                        std::span<const SettingGroup> allowed) {
  try {
    return apply(settings, toml::parse(text, file), file, allowed);
  } catch (const toml::parse_error& error) {
    return at_line(file, error.source(), error.description());
  }
}

}  // namespace slipstick
