#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "core/base/check.h"
#include "host/layer_slicer.h"
#include "host/slicing_job.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

using namespace bench;

namespace {

// A line of /proc/self/status, in MB.
double status_mb(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kib = 0;
    if (word == name && status >> kib) return kib / 1024;
  }
  return 0;
}

// Runs `measure` in a process of its own and gives its result: the peak of a process never comes
// down.
double in_child(const std::function<double()>& measure) {
  std::array<int, 2> ends{};
  SLIPSTICK_CHECK(::pipe(ends.data()) == 0);
  const pid_t child = ::fork();
  SLIPSTICK_CHECK(child >= 0);
  if (child == 0) {
    const double result = measure();
    ::_exit(::write(ends[1], &result, sizeof result) == sizeof result ? 0 : 1);
  }
  double result = 0;
  SLIPSTICK_CHECK(::read(ends[0], &result, sizeof result) == sizeof result);
  ::waitpid(child, nullptr, 0);
  ::close(ends[0]);
  ::close(ends[1]);
  return result;
}

// MB beyond the loaded solid while every layer is sliced into contours, two workers.
double slicing_mb(const std::shared_ptr<const Solid>& solid, double sampling) {
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins anew: loading is not slicing
  const double loaded = status_mb("VmRSS:");
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
  return status_mb("VmHWM:") - loaded;
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
