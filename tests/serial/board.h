#pragma once

#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <thread>
#include <utility>

#include "core/base/check.h"
#include "sim/printer.h"
#include "tests/serial/mocked_port.h"

namespace slipstick::test {

/// Said of a program that was started by hand; ctest preloads the mock, and then it must be there.
inline bool skipped() {
  if (MockedPort::mocked()) return false;
  REQUIRE(std::getenv("LD_PRELOAD") == nullptr);
  WARN("skipped: run by ctest, which mocks a serial port");
  return true;
}

/// A printer on the far side of a mocked port, a hundred times as fast as a real one. A fall of DTR
/// resets it.
class Board {
 public:
  Board(MockedPort& port, Printer printer)
      : port_(port), printer_(std::move(printer)), thread_([this](const std::stop_token& stop) {
          while (!stop.stop_requested()) turn();
        }) {}

  /// Any thread, as the next. The printer lives on.
  void unplug() { port_number_ = kOut; }
  /// It loses its power as well.
  void unplug_and_switch_off() {
    powered_ = false;
    unplug();
  }
  /// \param number of the ttyUSB that it comes back as, another than before.
  void plug_in(int number) { port_number_ = number; }

 private:
  static constexpr int kOut = -1;

  void turn() {
    heed_the_cable();
    if (MockedPort::dtr_falls() > falls_ || !powered_) printer_.reset();
    falls_ = MockedPort::dtr_falls();
    powered_ = true;
    pollfd wait{port_.board(), POLLIN, 0};
    ::poll(&wait, 1, 1);
    printer_.advance(printer_.now() + std::chrono::milliseconds(100));
    if (plugged_in_ != kOut) serve((wait.revents & POLLIN) != 0);
  }

  void heed_the_cable() {
    const int number = port_number_;
    if (number == plugged_in_) return;
    plugged_in_ == kOut ? port_.plug_in(number) : port_.unplug();
    plugged_in_ = number;
  }

  void serve(bool readable) {
    std::array<char, 512> bytes{};
    if (readable) {
      const auto got = ::read(port_.board(), bytes.data(), bytes.size());
      if (got > 0) printer_.receive({bytes.data(), static_cast<std::size_t>(got)}, printer_.now());
      printer_.advance(printer_.now());
    }
    const std::size_t said = printer_.take(bytes);
    if (said > 0) SLIPSTICK_CHECK(::write(port_.board(), bytes.data(), said) >= 0);
  }

  MockedPort& port_;
  int plugged_in_ = 0;
  int falls_ = MockedPort::dtr_falls();
  Printer printer_;
  std::atomic<int> port_number_ = 0;
  std::atomic<bool> powered_ = true;
  std::jthread thread_;  // last: it uses what stands above
};

}  // namespace slipstick::test
