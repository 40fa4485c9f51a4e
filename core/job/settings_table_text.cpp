#include "core/job/settings_table_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/number_text.h"

namespace slipstick {
namespace {

std::string with_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

std::string range_text(double low, double high) {
  std::string text;
  append_exact(text, low);
  text += " to ";
  append_exact(text, high);
  return text;
}

// What a setting may be.
struct RangeText {
  std::string_view unit;

  std::string operator()(const NumberSetting& kind) const {
    return with_unit(range_text(kind.low, kind.high), unit);
  }
  std::string operator()(const IntegerSetting& kind) const {
    return with_unit(fmt::format("whole, {} to {}", kind.low, kind.high), unit);
  }
  std::string operator()(const NameSetting&) const { return "text"; }
  std::string operator()(const GcodeSetting&) const { return "lines of G-code"; }
  std::string operator()(const ChoiceSetting& kind) const {
    return fmt::format("{}", fmt::join(kind.words, ", "));
  }
};

std::string range_of(const Setting& setting) {
  return std::visit(RangeText{setting.unit}, setting.kind);
}

}  // namespace

std::string commented_toml(const PrintSettings& settings, SettingGroup group) {
  std::string text = fmt::format("# Settings of the {}.\n", name_of(group));
  for (const Setting& setting : settings_of(group)) {
    text += fmt::format("\n# {}\n# {}; default {}.\n{} = {}\n", setting.help, range_of(setting),
                        toml_value(PrintSettings{}, setting), setting.key,
                        toml_value(settings, setting));
  }
  return text;
}

std::string settings_reference() {
  std::string text =
      "# Settings\n\nGenerated from the table in `core/job`; a test keeps both in step "
      "(`SLIPSTICK_ACCEPT=1` rewrites this file).\nSet them in files (see `configs/README.md`) or "
      "with `--set key=value`.\n";
  for (const SettingGroup group : kSettingGroups) {
    text +=
        fmt::format("\n## {}\n\n| key | allowed | default | meaning |\n| --- | --- | --- | --- |\n",
                    name_of(group));
    for (const Setting& setting : settings_of(group)) {
      text += fmt::format("| `{}` | {} | `{}` | {} |\n", setting.key, range_of(setting),
                          toml_value(PrintSettings{}, setting), setting.help);
    }
  }
  return text;
}

}  // namespace slipstick
