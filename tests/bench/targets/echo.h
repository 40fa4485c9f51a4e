#pragma once

#include <chrono>
#include <string>
#include <thread>

#include "drivers/unique_fd.h"

namespace slipstick::targets {

/// Acknowledges lines at the other end of a terminal, none before `pause` after the one before.
class Echo {
 public:
  explicit Echo(std::chrono::microseconds pause);
  ~Echo();
  Echo(const Echo&) = delete;
  Echo& operator=(const Echo&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  /// \pre the other side is open, so that the terminal is raw.
  void start();

 private:
  void run();
  void answer(std::string_view line);

  UniqueFd master_;
  UniqueFd held_;
  std::string path_;
  std::chrono::microseconds pause_;
  std::thread thread_;
};

}  // namespace slipstick::targets
