#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/job/settings.h"

namespace slipstick {

/// \file
/// Settings from TOML files: a printer, a material, a profile, and overrides; later ones win.

/// What `load_settings` is asked for. A name is looked up in the folders, whatever its case; what
/// has a
/// '/' or ends in ".toml" is a file.
struct SettingsRequest {
  std::string printer = "generic_marlin";
  std::string material = "pla";
  std::string profile = {};                 ///< Empty: none.
  std::vector<std::string> overrides = {};  ///< "key=value".
  /// Where printers/, materials/ and profiles/ are looked for, best first. Empty:
  /// `config_folders()`.
  std::vector<std::filesystem::path> folders = {};
};

/// The environment's SLIPSTICK_CONFIGS, ../share/slipstick/configs as seen from the program's
/// folder, the source's configs/, /usr/share/slipstick/configs.
[[nodiscard]] std::vector<std::filesystem::path> config_folders();

/// Reads all layers and checks that they suit each other.
///
/// A printer file may set every key, since machines want their own retraction and speeds; a
/// material its own and toolpath keys; a profile slicing and toolpath keys.
///
/// \return kInput for an unknown name, key or value ("ender3.toml:12: nozzel_diameter: unknown key;
/// …");
///   kUnavailable for a file that cannot be read.
[[nodiscard]] Result<PrintSettings> load_settings(const SettingsRequest& request);

}  // namespace slipstick
