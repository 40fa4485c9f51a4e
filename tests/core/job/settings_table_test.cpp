#include "core/job/settings_table.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "core/base/number_text.h"
#include "core/job/settings_table_check.h"
#include "core/job/settings_table_text.h"

using namespace slipstick;

namespace {

std::vector<Setting> all_settings() {
  std::vector<Setting> all;
  for (const SettingGroup group : kSettingGroups) {
    for (const Setting& setting : settings_of(group)) all.push_back(setting);
  }
  return all;
}

std::string exact(double value) {
  std::string text;
  append_exact(text, value);
  return text;
}

std::string error_of(std::string_view key, std::string_view text) {
  PrintSettings settings;
  const auto set = set_from_text(settings, key, text);
  REQUIRE_FALSE(set);
  CHECK(set.error().code == ErrorCode::kInput);
  return set.error().message;
}

// A range as the message about its breach says it.
struct Range {
  double low;
  double high;
};

void check_ends(const Setting& setting, Range range, double step) {
  CAPTURE(setting.key);
  const std::string allowed =
      fmt::format(" is out of range; {} to {}{}{} is allowed", exact(range.low), exact(range.high),
                  setting.unit.empty() ? "" : " ", setting.unit);
  for (const double end : {range.low, range.high}) {
    PrintSettings settings;

    CHECK(set_from_text(settings, setting.key, exact(end)));
    CHECK(parse_number(toml_value(settings, setting)) == end);
  }
  for (const double beyond : {range.low - step, range.high + step}) {
    CHECK(error_of(setting.key, exact(beyond)) ==
          fmt::format("{}: {:.10g}{}", setting.key, beyond, allowed));
  }
  CHECK(error_of(setting.key, "much") == fmt::format("{}: must be a number", setting.key));
  CHECK(error_of(setting.key, "nan") == fmt::format("{}: must be a number", setting.key));
}

std::string fault_of(const PrintSettings& settings) {
  const auto valid = validate(settings);
  return valid ? "" : valid.error().message;
}

}  // namespace

TEST_CASE("Keys are unique and say what they mean") {
  std::set<std::string_view> keys;
  for (const Setting& setting : all_settings()) {
    CAPTURE(setting.key);
    CHECK(keys.insert(setting.key).second);
    CHECK(setting.help.ends_with('.'));
    CHECK(setting.help.find('|') == std::string_view::npos);
    CHECK(*find_setting(setting.key).value()->key.data() == setting.key.front());
  }
}

TEST_CASE("Both ends of each range are allowed and nothing beyond") {
  for (const Setting& setting : all_settings()) {
    if (const auto* number = std::get_if<NumberSetting>(&setting.kind)) {
      check_ends(setting, {number->low, number->high}, 1e-6);
    }
    if (const auto* whole = std::get_if<IntegerSetting>(&setting.kind)) {
      check_ends(setting, {static_cast<double>(whole->low), static_cast<double>(whole->high)}, 1);
      CHECK(error_of(setting.key, exact(whole->low + 0.5)) ==
            fmt::format("{}: must be a whole number", setting.key));
    }
  }
}

TEST_CASE("Each word of a choice can be chosen and no other") {
  for (const Setting& setting : all_settings()) {
    const auto* choice = std::get_if<ChoiceSetting>(&setting.kind);
    if (choice == nullptr) continue;
    for (const std::string_view word : choice->words) {
      PrintSettings settings;

      CHECK(set_from_text(settings, setting.key, word));
      CHECK(toml_value(settings, setting) == fmt::format("\"{}\"", word));
    }
  }
  CHECK(error_of("place", "somewhere") ==
        "place: must be one of roots, sliding, projection, laplacian, midpoints");
}

TEST_CASE("Each setting writes its own member and no other's") {
  const PrintSettings defaults;
  for (const Setting& changed : all_settings()) {
    PrintSettings settings;
    std::string text = "another";
    if (const auto* n = std::get_if<NumberSetting>(&changed.kind)) text = exact(n->high);
    if (const auto* i = std::get_if<IntegerSetting>(&changed.kind)) text = exact(i->high);
    if (const auto* c = std::get_if<ChoiceSetting>(&changed.kind)) text = c->words.back();

    REQUIRE(set_from_text(settings, changed.key, text));

    for (const Setting& setting : all_settings()) {
      const bool same = toml_value(settings, setting) == toml_value(defaults, setting);
      const bool default_is_last = changed.key == "fan" || changed.key == "seam_angle";
      CAPTURE(changed.key, setting.key);
      if (setting.key != changed.key) CHECK(same);
      if (setting.key == changed.key && !default_is_last) CHECK_FALSE(same);
    }
  }
}

TEST_CASE("Defaults are in range and suit each other") {
  PrintSettings settings;
  for (const Setting& setting : all_settings()) {
    if (const auto* n = std::get_if<NumberSetting>(&setting.kind)) {
      CAPTURE(setting.key);
      CHECK(set_value(settings, setting, n->field(settings)));
    }
  }
  CHECK(fault_of(settings).empty());
}

TEST_CASE("An unknown key names the nearest one") {
  CHECK(error_of("nozzel_diameter", "0.4") ==
        "nozzel_diameter: unknown key; did you mean nozzle_diameter?");
  CHECK(error_of("layerheight", "0.2") == "layerheight: unknown key; did you mean layer_height?");
  CHECK(error_of("", "1").starts_with(": unknown key; did you mean "));
  CHECK(error_of(std::string(100000, 'x'), "1").find("unknown key") != std::string::npos);
}

TEST_CASE("G-code in settings keeps to the lines that can be sent") {
  const std::string key = "start_gcode";
  PrintSettings settings;

  CHECK(set_from_text(settings, key, "; heat\nM104 S{nozzle_celsius}\n\nG28\n"));
  CHECK(set_from_text(settings, key, std::string(80, 'G')));
  CHECK(error_of(key, "G28\n" + std::string(81, 'G')) ==
        "start_gcode: its line 2 is longer than 80 bytes");
  CHECK(error_of(key, "G28 *7").find("line 1 has a '*'") != std::string::npos);
  CHECK(error_of(key, "G28 ; home").find("has a comment behind a command") != std::string::npos);
  CHECK(error_of(key, "; 20\xC2\xB0").find("not printable ASCII") != std::string::npos);
  CHECK(error_of(key, std::string(8193, '\n')).find("longer than 8192") != std::string::npos);
}

TEST_CASE("Names are one line of ASCII") {
  PrintSettings settings;

  CHECK(set_from_text(settings, "printer_name", std::string(64, 'n')));
  CHECK(error_of("printer_name", std::string(65, 'n')).find("1 to 64") != std::string::npos);
  CHECK(error_of("printer_name", "").find("1 to 64") != std::string::npos);
  CHECK(error_of("printer_name", "a\nb").find("1 to 64") != std::string::npos);
}

TEST_CASE("Text is no number and a number is no text") {
  PrintSettings settings;

  CHECK_FALSE(set_value(settings, **find_setting("layer_height"), std::string("0.2")));
  CHECK_FALSE(set_value(settings, **find_setting("printer_name"), 3.0));
  CHECK_FALSE(set_value(settings, **find_setting("start_gcode"), 3.0));
  CHECK_FALSE(set_value(settings, **find_setting("place"), 0.0));
}

TEST_CASE("Settings that do not suit each other are named with their bound") {
  PrintSettings settings;
  settings.toolpath.line_width = 1.01;
  CHECK(fault_of(settings) ==
        "line_width: 1.01 must be 0.5 to 2.5 times nozzle_diameter, here 0.2 to 1");

  settings = {};
  settings.toolpath.first_layer_line_width = 0.19;
  CHECK(fault_of(settings).starts_with("first_layer_line_width: 0.19 must be"));

  settings = {};
  settings.slicing.layer_height = 0.41;
  CHECK(fault_of(settings) ==
        "layer_height: 0.41 must be no thicker than nozzle_diameter and line_width, here 0 to 0.4");

  settings = {};
  settings.slicing.first_layer_height = 0.41;
  CHECK(fault_of(settings).starts_with("first_layer_height: 0.41 must be no thicker"));

  settings = {};
  settings.printer.speed_max = 100;
  CHECK(fault_of(settings) == "travel_speed: 120 must be no faster than speed_max, here 0 to 100");
}

TEST_CASE("A dump shows help, range, default and value of each key") {
  PrintSettings settings;
  settings.slicing.layer_height = 0.3;

  const std::string text = commented_toml(settings, SettingGroup::kSlicing);

  CHECK(text.find("\n# 0.02 to 1.5 mm; default 0.2.\nlayer_height = 0.3\n") != std::string::npos);
}
