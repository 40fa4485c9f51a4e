#include "core/job/settings_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/job/settings_table_rows.h"

namespace slipstick {
namespace {

std::string number_text(double value) {
  std::string text;
  append_exact(text, value);
  return text;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t replaced = diagonal + (a[i] == b[k] ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({replaced, row[k] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string_view nearest_key(std::string_view key) {
  constexpr std::size_t kComparedMax = 64;
  std::string_view nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const SettingGroup group : kSettingGroups) {
    for (const Setting& setting : settings_of(group)) {
      const std::size_t distance = edit_distance(key.substr(0, kComparedMax), setting.key);
      if (distance < least) {
        least = distance;
        nearest = setting.key;
      }
    }
  }
  return nearest;
}

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

// What is wrong with the line, or empty.
std::string_view fault_of_gcode_line(std::string_view line) {
  if (line.size() > GcodeSetting::kLineSizeMax) return "is longer than 80 bytes";
  if (!is_printable(line)) return "has a character that is not printable ASCII";
  if (line.find('*') != std::string_view::npos) return "has a '*', which is for checksums";
  const std::size_t comment = line.find(';');
  if (comment != std::string_view::npos && line.find_first_not_of(' ') != comment) {
    return "has a comment behind a command; put it on a line of its own";
  }
  return {};
}

tl::unexpected<Error> refused(const Setting& setting, std::string_view why) {
  return fail(ErrorCode::kInput, fmt::format("{}: {}", setting.key, why));
}

// How each kind takes a value.
struct Setter {
  PrintSettings& settings;
  const Setting& setting;
  const SettingValue& value;

  Result<void> operator()(const NumberSetting& kind) const {
    const auto number = in_range(kind.low, kind.high);
    if (!number) return fail(number.error());
    kind.field(settings) = *number;
    return {};
  }

  Result<void> operator()(const IntegerSetting& kind) const {
    const auto number = in_range(kind.low, kind.high);
    if (!number) return fail(number.error());
    if (*number != std::floor(*number)) return refused(setting, "must be a whole number");
    kind.field(settings) = static_cast<int>(*number);
    return {};
  }

  Result<void> operator()(const NameSetting& kind) const {
    const std::string* text = std::get_if<std::string>(&value);
    if (text == nullptr) return refused(setting, "must be text in quotes");
    if (text->empty() || text->size() > NameSetting::kSizeMax || !is_printable(*text)) {
      return refused(setting, "must be 1 to 64 characters of printable ASCII");
    }
    kind.field(settings) = *text;
    return {};
  }

  Result<void> operator()(const GcodeSetting& kind) const {
    const std::string* text = std::get_if<std::string>(&value);
    if (text == nullptr) return refused(setting, "must be text in quotes");
    if (text->size() > GcodeSetting::kSizeMax) return refused(setting, "is longer than 8192 bytes");
    std::string_view rest = *text;
    for (int number = 1; !rest.empty(); ++number) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
      const std::string_view fault = fault_of_gcode_line(line);
      if (!fault.empty()) return refused(setting, fmt::format("its line {} {}", number, fault));
    }
    kind.field(settings) = *text;
    return {};
  }

  Result<void> operator()(const ChoiceSetting& kind) const {
    const std::string* text = std::get_if<std::string>(&value);
    const auto word =
        text == nullptr ? kind.words.end() : std::find(kind.words.begin(), kind.words.end(), *text);
    if (word == kind.words.end()) {
      return refused(setting, fmt::format("must be one of {}", fmt::join(kind.words, ", ")));
    }
    kind.write(settings, static_cast<std::size_t>(word - kind.words.begin()));
    return {};
  }

 private:
  [[nodiscard]] Result<double> in_range(double low, double high) const {
    const double* number = std::get_if<double>(&value);
    if (number == nullptr) return refused(setting, "must be a number");
    if (!(*number >= low && *number <= high)) {
      return refused(setting, fmt::format("{:.10g} is out of range; {} to {}{}{} is allowed",
                                          *number, number_text(low), number_text(high),
                                          setting.unit.empty() ? "" : " ", setting.unit));
    }
    return *number;
  }
};

std::string quoted(std::string_view text) {
  const bool lines = text.find('\n') != std::string_view::npos;
  std::string result = lines ? "\"\"\"\n" : "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + (lines ? "\"\"\"" : "\"");
}

struct ValueText {
  const PrintSettings& settings;

  std::string operator()(const NumberSetting& kind) const {
    return number_text(kind.field(settings));
  }
  std::string operator()(const IntegerSetting& kind) const {
    return fmt::format("{}", kind.field(settings));
  }
  std::string operator()(const NameSetting& kind) const { return quoted(kind.field(settings)); }
  std::string operator()(const GcodeSetting& kind) const { return quoted(kind.field(settings)); }
  std::string operator()(const ChoiceSetting& kind) const {
    return quoted(kind.words[kind.read(settings)]);
  }
};

}  // namespace

std::span<const Setting> settings_of(SettingGroup group) {
  switch (group) {
    case SettingGroup::kPrinter:
      return printer_rows();
    case SettingGroup::kMaterial:
      return material_rows();
    case SettingGroup::kSlicing:
      return slicing_rows();
    case SettingGroup::kToolpath:
      return toolpath_rows();
  }
  return {};
}

std::string_view name_of(SettingGroup group) {
  switch (group) {
    case SettingGroup::kPrinter:
      return "printer";
    case SettingGroup::kMaterial:
      return "material";
    case SettingGroup::kSlicing:
      return "slicing";
    case SettingGroup::kToolpath:
      return "toolpath";
  }
  return {};
}

Result<const Setting*> find_setting(std::string_view key) {
  for (const SettingGroup group : kSettingGroups) {
    for (const Setting& setting : settings_of(group)) {
      if (setting.key == key) return &setting;
    }
  }
  return fail(ErrorCode::kInput,
              fmt::format("{}: unknown key; did you mean {}?", key, nearest_key(key)));
}

Result<void> set_value(PrintSettings& settings, const Setting& setting, const SettingValue& value) {
  return std::visit(Setter{settings, setting, value}, setting.kind);
}

Result<void> set_from_text(PrintSettings& settings, std::string_view key, std::string_view text) {
  const auto setting = find_setting(key);
  if (!setting) return fail(setting.error());
  const bool is_number = std::holds_alternative<NumberSetting>((*setting)->kind) ||
                         std::holds_alternative<IntegerSetting>((*setting)->kind);
  const auto number = is_number ? parse_number(text) : std::nullopt;
  return set_value(settings, **setting,
                   number ? SettingValue(*number) : SettingValue(std::string(text)));
}

std::string toml_value(const PrintSettings& settings, const Setting& setting) {
  return std::visit(ValueText{settings}, setting.kind);
}

}  // namespace slipstick
