#include <fmt/format.h>

#include "core/base/check.h"
#include "core/image/sample.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

using namespace bench;

namespace {

constexpr int kRounds = 30;

Row prospero_row(const std::string& file, int nodes, double target_ms) {
  constexpr double kSize = 100;
  const Subject s = subject("prospero", vm_solid(file, kSize), kSize / (nodes - 3));
  const Timing timing = cpu_seconds(kRounds, [&s] {
    const auto section = s.solid->section(s.z);
    SLIPSTICK_CHECK(sample(*section, s.grid).has_value());
  });
  return {fmt::format("fidget_prospero.vm {}², bit image, one core", s.grid.columns()),
          fmt::format("≤ {} ms", target_ms), timing.text("ms"), timing.least <= target_ms * 1e-3};
}

}  // namespace

std::vector<Row> image_rows() {
  const std::string folder = models_folder();
  if (folder.empty()) {
    return {
        {"fidget_prospero.vm", "≤ 3 / ≤ 12 ms", "left out: SLIPSTICK_MODELS is not set", false}};
  }
  const std::string file = folder + "/fidget_prospero.vm";
  return {prospero_row(file, 1024, 3), prospero_row(file, 4096, 12)};
}

}  // namespace slipstick::targets
