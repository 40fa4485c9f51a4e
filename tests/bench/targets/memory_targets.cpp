#include <fmt/format.h>

#include "core/base/check.h"
#include "host/layer_slicer.h"
#include "host/process_memory.h"
#include "host/slicing_job.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/child_process.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

using namespace bench;

namespace {

// MB beyond the loaded solid while every layer is sliced into contours, two workers.
double slicing_mb(const std::shared_ptr<const Solid>& solid, double sampling) {
  const double loaded = begin_peak_anew();  // loading is not slicing
  SlicingRequest request;
  request.settings.slicing.sampling = sampling;
  request.settings.slicing.layer_height = 0.254;
  request.settings.slicing.first_layer_height = 0.254;
  request.goal = SliceGoal::kContours;
  request.threads = 2;
  auto job = SlicingJob::start({solid, solid->bounds(), {}}, request);
  SLIPSTICK_CHECK(job.has_value());
  while (true) {
    const auto layer = (*job)->next();
    SLIPSTICK_CHECK(layer.has_value());
    if (!*layer) break;
  }
  return peak_mb() - loaded;
}

}  // namespace

std::vector<Row> memory_rows() {
  std::string measured;
  bool holds = true;
  for (std::size_t i = 0; i < (models_folder().empty() ? 2U : 3U); ++i) {
    std::string name;
    const double mb = in_child([i] {
      const Subject s = std::move(filigree_layers()[i]);
      return slicing_mb(s.solid, s.grid.width());
    });
    holds &= mb <= 64;
    measured += fmt::format("{}{:.0f} MB", i > 0 ? ", " : "", mb);
  }
  return {
      {"peak memory beyond the solid, Filigree stand-ins (rings, gyroid, syn_filigree.ply), r' "
       "0.0025 in",
       "≤ 64 MB", measured, holds}};
}

}  // namespace slipstick::targets
