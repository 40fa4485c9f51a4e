#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "drivers/unique_fd.h"

namespace slipstick::test {

/// A process beside the test; killed with its owner.
class ChildProcess {
 public:
  /// The `slipstick` that was built with the tests.
  explicit ChildProcess(std::vector<std::string> arguments);
  /// `program`, looked for as a shell does.
  ChildProcess(const std::string& program, std::vector<std::string> arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for the next line on its standard output; what there is of it if that ends.
  [[nodiscard]] std::string line();
  void send(int signal) const;
  /// Waits for its end. \return the exit status, or 128 + the signal.
  int wait();
  [[nodiscard]] pid_t pid() const { return process_; }

 private:
  pid_t process_ = -1;
  UniqueFd out_;
};

}  // namespace slipstick::test
