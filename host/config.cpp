#include "host/config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/job/settings_table.h"
#include "core/job/settings_table_check.h"
#include "host/config_file.h"

namespace slipstick {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFileSizeMax = 1 << 20;

constexpr std::array kPrinterGroups{SettingGroup::kPrinter, SettingGroup::kMaterial,
                                    SettingGroup::kSlicing, SettingGroup::kToolpath};
constexpr std::array kMaterialGroups{SettingGroup::kMaterial, SettingGroup::kToolpath};
constexpr std::array kProfileGroups{SettingGroup::kSlicing, SettingGroup::kToolpath};

// One of the three kinds of file.
struct Layer {
  std::string_view what;
  std::string_view folder;
  std::span<const SettingGroup> allowed;
};
constexpr Layer kPrinterLayer{"printer", "printers", kPrinterGroups};
constexpr Layer kMaterialLayer{"material", "materials", kMaterialGroups};
constexpr Layer kProfileLayer{"profile", "profiles", kProfileGroups};

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool is_file_name(std::string_view name) {
  return name.find('/') != std::string_view::npos || name.ends_with(".toml");
}

// The TOML files of `folder`, by name; none if it cannot be read.
std::vector<fs::path> toml_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  const fs::directory_iterator end;
  for (fs::directory_iterator entry(folder, error); !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".toml") files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Result<fs::path> resolved(const Layer& layer, const std::string& name,
                          const std::vector<fs::path>& folders) {
  if (is_file_name(name)) return fs::path(name);
  std::vector<std::string> known;
  for (const fs::path& folder : folders) {
    for (const fs::path& file : toml_files(folder / layer.folder)) {
      known.push_back(file.stem().string());
      if (lower_case(known.back()) == lower_case(name)) return file;
    }
  }
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  return fail(
      ErrorCode::kInput,
      fmt::format("{} \"{}\" is not known; there are {} (or give a .toml file)", layer.what, name,
                  known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

Result<std::string> contents_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kFileSizeMax + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  // A folder opens, and fails to read.
  if (!file.is_open() || file.bad()) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("{}: cannot be read; is the path right?", path.string()));
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kFileSizeMax) {
    return fail(ErrorCode::kInput,
                fmt::format("{}: is larger than 1 MiB and no settings file", path.string()));
  }
  return text;
}

Result<void> apply_layer(PrintSettings& settings, const Layer& layer, const std::string& name,
                         const std::vector<fs::path>& folders) {
  const auto path = resolved(layer, name, folders);
  if (!path) return fail(path.error());
  const auto text = contents_of(*path);
  if (!text) return fail(text.error());
  return apply_toml(settings, *text, path->string(), layer.allowed);
}

Result<void> apply_override(PrintSettings& settings, std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) {
    return fail(ErrorCode::kInput, fmt::format("{}: expected key=value", text));
  }
  return set_from_text(settings, text.substr(0, equals), text.substr(equals + 1));
}

}  // namespace

std::vector<fs::path> config_folders() {
  std::vector<fs::path> folders;
  if (const char* folder = std::getenv("SLIPSTICK_CONFIGS")) folders.emplace_back(folder);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) folders.push_back(program.parent_path().parent_path() / "share/slipstick/configs");
  folders.emplace_back(SLIPSTICK_CONFIGS);
  folders.emplace_back("/usr/share/slipstick/configs");
  return folders;
}

Result<PrintSettings> load_settings(const SettingsRequest& request) {
  const auto folders = request.folders.empty() ? config_folders() : request.folders;
  const std::array<std::pair<Layer, const std::string*>, 3> layers{{
      {kPrinterLayer, &request.printer},
      {kMaterialLayer, &request.material},
      {kProfileLayer, &request.profile},
  }};
  PrintSettings settings;
  for (const auto& [layer, name] : layers) {
    if (name->empty() && layer.what == kProfileLayer.what) continue;
    const auto applied = apply_layer(settings, layer, *name, folders);
    if (!applied) return fail(applied.error());
  }
  for (const std::string& text : request.overrides) {
    const auto applied = apply_override(settings, text);
    if (!applied) return fail(applied.error());
  }
  if (const auto valid = validate(settings); !valid) return fail(valid.error());
  return settings;
}

}  // namespace slipstick
