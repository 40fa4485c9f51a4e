#include "tests/bench/targets/child_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "core/base/check.h"

namespace slipstick::targets {

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
