#include "tests/bench/targets/echo.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>

#include "core/base/check.h"

namespace slipstick::targets {

Echo::Echo(std::chrono::microseconds pause)
    : master_(::posix_openpt(O_RDWR | O_NOCTTY)), pause_(pause) {
  SLIPSTICK_CHECK(master_.valid() && ::grantpt(master_.get()) == 0 &&
                  ::unlockpt(master_.get()) == 0);
  std::array<char, 128> name{};
  SLIPSTICK_CHECK(::ptsname_r(master_.get(), name.data(), name.size()) == 0);
  path_ = name.data();
  held_ = UniqueFd(::open(path_.c_str(), O_RDWR | O_NOCTTY));
}

Echo::~Echo() {
  // What ends its last read.
  SLIPSTICK_CHECK(::write(held_.get(), "\x04\n", 2) == 2);
  thread_.join();
}

void Echo::start() {
  thread_ = std::thread([this] { run(); });
}

void Echo::run() {
  using Steady = std::chrono::steady_clock;
  std::string line;
  std::array<char, 4096> bytes{};
  auto due = Steady::now();
  while (true) {
    const ssize_t count = ::read(master_.get(), bytes.data(), bytes.size());
    if (count <= 0) return;
    for (const char byte : std::string_view(bytes.data(), static_cast<std::size_t>(count))) {
      if (byte == '\x04') return;
      line += byte;
      if (byte != '\n') continue;
      std::this_thread::sleep_until(due);
      due = Steady::now() + pause_;
      answer(line);
      line.clear();
    }
  }
}

void Echo::answer(std::string_view line) {
  std::string_view text = "ok\n";
  if (line.find("M105") != std::string_view::npos) text = "ok T:20.0 /0.0 B:20.0 /0.0\n";
  if (line.find("M115") != std::string_view::npos) {
    text = "FIRMWARE_NAME:Marlin 2.1.2\nCap:AUTOREPORT_TEMP:1\nok\n";
  }
  SLIPSTICK_CHECK(::write(master_.get(), text.data(), text.size()) > 0);
}

}  // namespace slipstick::targets
