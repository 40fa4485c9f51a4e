#include "host/config.h"

#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/job/settings_table_text.h"
#include "host/config_file.h"

using namespace slipstick;
namespace fs = std::filesystem;

namespace {

const fs::path kShipped = fs::path(SLIPSTICK_SOURCE_DIR) / "configs";

// A folder of its own that is gone after the test.
class TemporaryConfigs {
 public:
  TemporaryConfigs() {
    std::string pattern = (fs::temp_directory_path() / "slipstick-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
    for (const char* folder : {"printers", "materials", "profiles"}) {
      fs::create_directory(path_ / folder);
    }
  }
  TemporaryConfigs(const TemporaryConfigs&) = delete;
  TemporaryConfigs& operator=(const TemporaryConfigs&) = delete;
  ~TemporaryConfigs() { fs::remove_all(path_); }

  fs::path with(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::vector<fs::path> shipped(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kShipped / folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string error_of(const SettingsRequest& request) {
  const auto settings = load_settings(request);
  REQUIRE_FALSE(settings);
  return settings.error().message;
}

constexpr SettingGroup kProfile[] = {SettingGroup::kSlicing, SettingGroup::kToolpath};

std::string toml_error_of(std::string_view text) {
  PrintSettings settings;
  const auto applied = apply_toml(settings, text, "a.toml", kProfile);
  REQUIRE_FALSE(applied);
  CHECK(applied.error().code == ErrorCode::kInput);
  CHECK(applied.error().message.find('\n') == std::string::npos);
  return applied.error().message;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("Every shipped printer goes with every material and profile") {
  for (const fs::path& printer : shipped("printers")) {
    for (const fs::path& material : shipped("materials")) {
      for (const fs::path& profile : shipped("profiles")) {
        const auto settings = load_settings({.printer = printer.string(),
                                             .material = material.string(),
                                             .profile = profile.string()});

        INFO((settings ? "" : settings.error().message));
        REQUIRE(settings);
      }
    }
  }
}

TEST_CASE("Every shipped printer heats, homes and primes on its bed, and ends cold") {
  for (const fs::path& file : shipped("printers")) {
    CAPTURE(file);
    const auto settings = load_settings({.printer = file.string()});
    REQUIRE(settings);
    const std::string& start = settings->printer.start_gcode;
    const std::string& end = settings->printer.end_gcode;

    for (const char* line : {"G90\n", "M83\n", "M140 S{bed_celsius}\n", "M190 S{bed_celsius}\n",
                             "M109 S{nozzle_celsius}\n", "\nG28"}) {
      CHECK(start.find(line) != std::string::npos);
    }
    CHECK(start.find("M109") < start.find("G1 "));
    CHECK(start.find("\nG28") < start.find("\nG1 "));
    for (const char* line : {"M104 S0\n", "M140 S0\n", "M107\n", "G90\n", "M84\n"}) {
      CHECK(end.find(line) != std::string::npos);
    }
  }
}

TEST_CASE("Without a wish it is the generic printer with PLA and the table's defaults") {
  const auto settings = load_settings({});

  REQUIRE(settings);
  PrintSettings expected;
  expected.printer.start_gcode = settings->printer.start_gcode;
  expected.printer.end_gcode = settings->printer.end_gcode;
  for (const SettingGroup group : kSettingGroups) {
    CHECK(commented_toml(*settings, group) == commented_toml(expected, group));
  }
}

TEST_CASE("Later layers win, overrides over all") {
  const TemporaryConfigs configs;
  configs.with("printers/p.toml", "infill_speed = 41\nskin_speed = 42\nseam_angle = 1\nfan = 0.1");
  configs.with("materials/m.toml", "skin_speed = 43\nseam_angle = 2");
  configs.with("profiles/f.toml", "seam_angle = 3\nlayer_height = 0.1");
  const SettingsRequest request{.printer = "p",
                                .material = "m",
                                .profile = "f",
                                .overrides = {"layer_height=0.15", "printer_name=a=b"},
                                .folders = {configs.path()}};

  const auto settings = load_settings(request);

  REQUIRE(settings);
  CHECK(settings->material.fan == 0.1);
  CHECK(settings->toolpath.infill_speed == 41);
  CHECK(settings->toolpath.skin_speed == 43);
  CHECK(settings->toolpath.seam_angle == 3);
  CHECK(settings->slicing.layer_height == 0.15);
  CHECK(settings->printer.name == "a=b");
}

TEST_CASE("Names are found whatever their case, in the first folder that has them") {
  const TemporaryConfigs mine;
  mine.with("materials/Petg.toml", "density = 2");
  const SettingsRequest request{
      .printer = "Ender3", .material = "PETG", .folders = {mine.path(), kShipped}};

  const auto settings = load_settings(request);

  REQUIRE(settings);
  CHECK(settings->printer.name == "Creality Ender 3");
  CHECK(settings->material.density == 2);
}

TEST_CASE("An unknown name lists what there is") {
  const TemporaryConfigs configs;
  configs.with("printers/one.toml", "");
  configs.with("printers/two.toml", "");

  CHECK(error_of({.printer = "three", .folders = {configs.path()}}) ==
        "printer \"three\" is not known; there are one, two (or give a .toml file)");
  CHECK(error_of({.printer = "one", .material = "pla", .folders = {configs.path()}}) ==
        "material \"pla\" is not known; there are none (or give a .toml file)");
}

TEST_CASE("A file that cannot be read is named") {
  const auto missing = load_settings({.printer = "/no/such.toml"});
  const auto folder = load_settings({.printer = kShipped.string()});

  REQUIRE_FALSE(missing);
  CHECK(missing.error() ==
        Error{ErrorCode::kUnavailable, "/no/such.toml: cannot be read; is the path right?"});
  REQUIRE_FALSE(folder);
  CHECK(folder.error().code == ErrorCode::kUnavailable);
}

TEST_CASE("A huge file is no settings file") {
  const TemporaryConfigs configs;
  const fs::path file = configs.with("big.toml", std::string((1 << 20) + 1, '#'));

  CHECK(error_of({.printer = file.string()}).find("larger than 1 MiB") != std::string::npos);
}

TEST_CASE("Mistakes in a file are told with its line and key") {
  CHECK(toml_error_of("\n# width\nline_widht = 0.4\n") ==
        "a.toml:3: line_widht: unknown key; did you mean line_width?");
  CHECK(toml_error_of("layer_height = 0.2\nsampling = 3\n") ==
        "a.toml:2: sampling: 3 is out of range; 0.002 to 2 mm is allowed");
  CHECK(toml_error_of("layer_height = \"thin\"") == "a.toml:1: layer_height: must be a number");
  CHECK(toml_error_of("layer_height = true") == "a.toml:1: layer_height: must be a number or text");
  CHECK(toml_error_of("[layer_height]\nx = 1") ==
        "a.toml:1: layer_height: must be a number or text");
  CHECK(toml_error_of("perimeters = 1.5") == "a.toml:1: perimeters: must be a whole number");
  CHECK(toml_error_of("layer_height = nan").starts_with("a.toml:1: layer_height: nan is out of"));
  CHECK(toml_error_of("\nbaud = 9600") ==
        "a.toml:2: baud: is a printer setting and cannot stand in this kind of file");
  CHECK(toml_error_of("layer_height = 0.2\nlayer_height = 0.3").starts_with("a.toml:2: "));
  CHECK(toml_error_of("layer_height = \n").starts_with("a.toml:1: "));
}

TEST_CASE("The first mistake of a file is reported") {
  CHECK(toml_error_of("zzz = 1\naaa = 1").starts_with("a.toml:1: zzz: unknown key"));
}

TEST_CASE("Mistakes in overrides name the key") {
  CHECK(error_of({.overrides = {"layer_height"}}) == "layer_height: expected key=value");
  CHECK(error_of({.overrides = {"layer_hight=1"}}) ==
        "layer_hight: unknown key; did you mean layer_height?");
  CHECK(error_of({.overrides = {"perimeters="}}) == "perimeters: must be a number");
}

TEST_CASE("Settings that do not suit each other are refused") {
  CHECK(error_of({.overrides = {"layer_height=0.5"}}).starts_with("layer_height: 0.5 must be"));
}

TEST_CASE("A dumped group can be loaded again") {
  const auto settings = load_settings({.printer = "prusa_mk3", .material = "tpu"});
  REQUIRE(settings);
  for (const SettingGroup group : kSettingGroups) {
    const std::string dump = commented_toml(*settings, group);
    PrintSettings again;

    REQUIRE(apply_toml(again, dump, "dump", {&group, 1}));

    CHECK(commented_toml(again, group) == dump);
  }
}

TEST_CASE("The reference of settings is in step with the table") {
  const fs::path path = fs::path(SLIPSTICK_SOURCE_DIR) / "docs" / "SETTINGS.md";
  if (std::getenv("SLIPSTICK_ACCEPT") != nullptr) std::ofstream(path) << settings_reference();

  CHECK(text_of(path) == settings_reference());
}
