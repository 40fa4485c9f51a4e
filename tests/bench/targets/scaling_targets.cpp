#include <fmt/format.h>

#include "core/base/check.h"
#include "host/slicing_job.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

using namespace bench;

namespace {

constexpr int kRounds = 5;

void slice(const PlacedSolid& placed, double sampling, int threads) {
  SlicingRequest request;
  request.settings.slicing.sampling = sampling;
  request.goal = SliceGoal::kContours;
  request.threads = threads;
  request.first_layer = 80;
  request.end_layer = 120;
  auto job = SlicingJob::start(placed, request);
  SLIPSTICK_CHECK(job.has_value());
  while (true) {
    const auto layer = (*job)->next();
    SLIPSTICK_CHECK(layer.has_value());
    if (!*layer) return;
  }
}

}  // namespace

std::vector<Row> scaling_rows() {
  const PlacedSolid placed = example_on_bed();
  const Timing coarse = cpu_seconds(kRounds, [&] { slice(placed, 0.05, 1); });
  const Timing fine = cpu_seconds(kRounds, [&] { slice(placed, 0.025, 1); });
  const double halved = fine.least / coarse.least;
  const Timing one = wall_seconds(kRounds, [&] { slice(placed, 0.025, 1); });
  const Timing two = wall_seconds(kRounds, [&] { slice(placed, 0.025, 2); });
  const double speedup = one.least / two.least;
  return {
      {"time per layer when r' is halved (example, 40 layers, contours)", "≤ 2.3 ×",
       fmt::format("{:.2f} × ({}, {})", halved, coarse.text("ms"), fine.text("ms")), halved <= 2.3},
      {"two workers against one (same layers)", "≥ 1.8 ×",
       fmt::format("{:.2f} × ({}, {})", speedup, one.text("ms"), two.text("ms")), speedup >= 1.8}};
}

}  // namespace slipstick::targets
