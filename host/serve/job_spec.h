#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "core/base/box.h"
#include "core/job/placement.h"
#include "core/job/settings_change.h"
#include "host/config.h"
#include "host/slicing_job.h"

namespace slipstick {

/// How a file is to be printed, as a client says it in JSON:
///
///     {"printer": "ender3", "material": "pla", "profile": "fine", "settings": {"perimeters": 3},
///      "placement": {"units": "mm", "scale": 1, "fit": [x, y, z], "rotate": [x, y, z],
///                    "direction": [x, y, z], "bounds": [x0, y0, z0, x1, y1, z1]}}
///
/// All members are optional. Names are those of files in `configs/`, never paths.
struct JobSpec {
  SettingsRequest settings;
  PlacementRequest placement;
  Box3 bounds{{-1, -1, -1}, {1, 1, 1}};  ///< Extent of a `.vm` expression, in its units.
};

/// The printer that jobs are for unless they say otherwise.
struct JobDefaults {
  std::string printer = "generic_marlin";
  std::string material = "pla";
  std::string profile = {};
};

/// The settings of jobs that do not say otherwise.
[[nodiscard]] SettingsRequest default_settings(const JobDefaults& defaults);

/// Reads a job's JSON and checks that its settings load. \return kInput with the member at fault;
/// unknown members are errors.
[[nodiscard]] Result<JobSpec> job_spec(const nlohmann::json& json, const JobDefaults& defaults);
/// The same from text.
[[nodiscard]] Result<JobSpec> job_spec_from_text(std::string_view text,
                                                 const JobDefaults& defaults);

/// Settings as a client says them: {"perimeters": 3, "infill_density": 0.4}.
/// \return kInput for anything else; whether there are such settings is not looked at.
[[nodiscard]] Result<SettingTexts> setting_texts(const nlohmann::json& json);

/// A model on the bed and how it is sliced: what `SlicingJob` starts from.
struct PreparedModel {
  PlacedSolid placed;
  SlicingRequest request;
  std::string warning;  ///< Of the loader, or empty.
};

/// Loads and places the model in `path`, which users know as `name`.
[[nodiscard]] Result<PreparedModel> prepare_model(const std::string& path, const std::string& name,
                                                  const JobSpec& spec, SliceGoal goal);

}  // namespace slipstick
