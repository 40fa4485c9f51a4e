#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "tests/support/child_process.h"

namespace slipstick::test {

/// `slipstick serve` as a process of its own, on a port of its own.
class DaemonProcess {
 public:
  DaemonProcess(const std::filesystem::path& data, const std::string& printer);

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] pid_t pid() const { return process_.pid(); }
  /// Sends `signal` and waits for the end. \return the exit status, or 128 + the signal.
  int end(int signal);

 private:
  ChildProcess process_;
  std::uint16_t port_ = 0;
};

}  // namespace slipstick::test
