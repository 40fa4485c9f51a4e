#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "drivers/unique_fd.h"

namespace slipstick::test {

/// The simplest printer there can be, behind a socket: it acknowledges every line and remembers
/// each command. A witness of what was sent, whoever sends it and however often that one dies.
class ObedientPrinter {
 public:
  ObedientPrinter();
  ~ObedientPrinter();
  ObedientPrinter(const ObedientPrinter&) = delete;
  ObedientPrinter& operator=(const ObedientPrinter&) = delete;

  /// "tcp:127.0.0.1:43211"
  [[nodiscard]] std::string address() const;
  /// Without numbers and checksums, over all connections.
  [[nodiscard]] std::vector<std::string> commands() const;
  [[nodiscard]] std::size_t count() const;

 private:
  void run();
  void serve(int connection);

  UniqueFd listener_;
  std::uint16_t port_ = 0;
  mutable std::mutex mutex_;  // protects what follows
  std::vector<std::string> commands_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace slipstick::test
