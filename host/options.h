#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/job/placement.h"
#include "host/load_model.h"
#include "host/slicing_job.h"

namespace slipstick {

/// \file
/// Command-line options that several commands share, and what they come to.

/// Adds `--winding` and `--resolution`.
void add_mesh_options(CLI::App& app, LoadOptions& options);

/// Adds an option whose value is `count` numbers in one word, "1,2.5,3": what follows it is not
/// its.
CLI::Option* add_numbers_option(CLI::App& app, const std::string& name,
                                std::vector<double>& numbers, std::size_t count,
                                const std::string& help);

/// Adds `--bounds`.
void add_bounds_option(CLI::App& app, std::vector<double>& bounds);
/// What came of it. \return kInput unless they are six rising numbers or none.
[[nodiscard]] Result<void> apply_bounds(const std::vector<double>& bounds, LoadOptions& options);

/// A solid on the bed, from the options of `slice`, `print`, `info` and `verify`.
struct ModelOptions {
  std::string path;
  std::vector<double> bounds;  ///< Six numbers, or none.
  std::string units = "mm";
  double scale = 1;
  std::vector<double> fit;
  std::vector<double> rotate;
  std::vector<double> direction;
  LoadOptions loading;  ///< `bounds` in it is not used.

  /// Everything but the path, which each command names for itself.
  void add_to(CLI::App& app);
  /// Of them, what is needed to load it: `--as`, `--winding`, `--resolution`, `--bounds`.
  void add_loading_to(CLI::App& app);

  [[nodiscard]] Result<LoadedModel> load() const;
  [[nodiscard]] PlacementRequest placement() const;
};

/// Settings, threads and layers, from the options of `slice` and `print`.
struct SlicingOptions {
  std::string printer = "generic_marlin";
  std::string material = "pla";
  std::string profile;
  std::vector<std::string> set;
  std::string layers;
  int threads = 0;
  std::string report;

  void add_to(CLI::App& app);

  /// Also applies the options that stand for a setting (`--layer-height` for `layer_height`, …).
  [[nodiscard]] Result<SlicingRequest> request(SliceGoal goal) const;

 private:
  std::vector<std::string> shorthands_;  // key=value
};

}  // namespace slipstick
