#include "tests/bench/targets/process_memory.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <string>

#include "core/base/check.h"

namespace slipstick::targets {

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

}  // namespace

double begin_peak_anew() {
  std::ofstream("/proc/self/clear_refs") << 5;
  return status_mb("VmRSS:");
}

double peak_mb() {
  return status_mb("VmHWM:");
}

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

}  // namespace slipstick::targets
