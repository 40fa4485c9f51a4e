#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/slicing_job.h"

namespace slipstick {

/// What a slicing job did, in the form of INTERFACES: `--report FILE.json`.
struct ReportContext {
  std::string model;
  std::string representation;
  double load_seconds = 0;
  double total_seconds = 0;
  double first_extrusion_seconds =
      0;  ///< From the start of the program to the first extruding line.
};

[[nodiscard]] nlohmann::ordered_json slicing_report(const SlicingJob& job,
                                                    const PrintSettings& settings,
                                                    const ReportContext& context);

/// The most memory this process ever had, in bytes.
[[nodiscard]] long peak_rss_bytes();

}  // namespace slipstick
