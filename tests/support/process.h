#pragma once

#include <string>
#include <vector>

namespace slipstick::test {

/// What a program left behind.
struct Finished {
  int status = -1;  ///< Exit status, or 128 + the signal that ended it.
  std::string out;
  std::string err;
};

/// Runs `arguments[0]`, found as it stands, and waits for it; ended after 120 seconds.
[[nodiscard]] Finished run(const std::vector<std::string>& arguments);

/// Runs the `slipstick` that was built with the tests.
[[nodiscard]] Finished slipstick(std::vector<std::string> arguments);

}  // namespace slipstick::test
