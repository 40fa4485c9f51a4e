#include "tests/bench/targets/table.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>

namespace slipstick::targets {
namespace {

double seconds(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Timing timed(clockid_t clock, int rounds, const std::function<void()>& work) {
  Timing timing{1e9, 0};
  for (int round = 0; round < rounds; ++round) {
    const double begin = seconds(clock);
    work();
    const double took = seconds(clock) - begin;
    timing = {std::min(timing.least, took), std::max(timing.most, took)};
  }
  return timing;
}

}  // namespace

std::string Timing::text(std::string_view unit) const {
  const double factor = unit == "ns" ? 1e9 : unit == "ms" ? 1e3 : 1;
  return fmt::format("{:.3g} {} (+{:.0f} %)", least * factor, unit, 100 * (most / least - 1));
}

Timing cpu_seconds(int rounds, const std::function<void()>& work) {
  return timed(CLOCK_PROCESS_CPUTIME_ID, rounds, work);
}

Timing wall_seconds(int rounds, const std::function<void()>& work) {
  return timed(CLOCK_MONOTONIC, rounds, work);
}

void print(const std::vector<Row>& rows) {
  fmt::print("| what | target | measured | holds |\n| --- | --- | --- | --- |\n");
  for (const Row& row : rows) {
    fmt::print("| {} | {} | {} | {} |\n", row.what, row.target, row.measured,
               row.holds ? "yes" : "NO");
  }
}

}  // namespace slipstick::targets
