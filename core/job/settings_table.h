#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/result.h"
#include "core/job/settings.h"

namespace slipstick {

/// \file
/// The one table of all settings. Loaders, `--set key=value`, dumps and docs/SETTINGS.md go through
/// it.

/// Which struct of `PrintSettings` a setting is in.
enum class SettingGroup : std::uint8_t { kPrinter, kMaterial, kSlicing, kToolpath };

/// A member of `PrintSettings`, made from a generic lambda that returns it.
template <typename T>
class SettingField {
 public:
  template <typename Member>
  requires std::convertible_to<Member, T& (*)(PrintSettings&)>
  constexpr SettingField(Member member) : write_(member), read_(member) {}

  T& operator()(PrintSettings& settings) const { return write_(settings); }
  const T& operator()(const PrintSettings& settings) const { return read_(settings); }

 private:
  T& (*write_)(PrintSettings&);
  const T& (*read_)(const PrintSettings&);
};

/// A number, both ends of its range allowed.
struct NumberSetting {
  SettingField<double> field;
  double low;
  double high;
};

/// A whole number, both ends of its range allowed.
struct IntegerSetting {
  SettingField<int> field;
  int low;
  int high;
};

/// One line of printable ASCII, 1 to 64 characters.
struct NameSetting {
  SettingField<std::string> field;
  static constexpr std::size_t kSizeMax = 64;
};

/// Lines of G-code as `LayerProgram` wants them: at most 80 bytes of printable ASCII, no '*',
/// comments on lines of their own.
struct GcodeSetting {
  SettingField<std::string> field;
  static constexpr std::size_t kLineSizeMax = 80;
  static constexpr std::size_t kSizeMax = 8192;
};

/// One of several words, by its place among them.
struct ChoiceSetting {
  std::span<const std::string_view> words;
  std::size_t (*read)(const PrintSettings&);
  void (*write)(PrintSettings&, std::size_t);
};

/// One row of the table.
struct Setting {
  std::string_view key;
  SettingGroup group;
  std::string_view unit;  ///< Empty for words, counts and shares.
  std::variant<NumberSetting, IntegerSetting, NameSetting, GcodeSetting, ChoiceSetting> kind;
  std::string_view help;  ///< What it is and how a user finds the right value.
};

/// All of one group, in the order of the struct.
[[nodiscard]] std::span<const Setting> settings_of(SettingGroup group);

inline constexpr SettingGroup kSettingGroups[] = {SettingGroup::kPrinter, SettingGroup::kMaterial,
                                                  SettingGroup::kSlicing, SettingGroup::kToolpath};

/// "printer", "material", "slicing", "toolpath".
[[nodiscard]] std::string_view name_of(SettingGroup group);

/// \return kInput for an unknown key; the message names the nearest one.
[[nodiscard]] Result<const Setting*> find_setting(std::string_view key);

/// A value before it is known to suit a setting.
using SettingValue = std::variant<double, std::string>;

/// Sets one setting, or leaves it and returns kInput: "key: what is wrong with the value".
[[nodiscard]] Result<void> set_value(PrintSettings& settings, const Setting& setting,
                                     const SettingValue& value);

/// The same from text, as on a command line. \return kInput also for an unknown key.
[[nodiscard]] Result<void> set_from_text(PrintSettings& settings, std::string_view key,
                                         std::string_view text);

/// The value as it would stand in TOML.
[[nodiscard]] std::string toml_value(const PrintSettings& settings, const Setting& setting);

}  // namespace slipstick
