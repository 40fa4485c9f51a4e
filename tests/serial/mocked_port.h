#pragma once

#include <umockdev.h>

#include <memory>
#include <string>

#include "drivers/unique_fd.h"

namespace slipstick::test {

/// A serial port that this machine does not have: a CH340 with serial number A1B2 on a USB bus, and
/// the other end of its cable. Only for programs under umockdev (see `mocked`), one at a time.
class MockedPort {
 public:
  static constexpr const char* kPath = "/dev/ttyUSB0";

  /// Whether this process sees mocked devices: ctest's does, one started by hand does not.
  [[nodiscard]] static bool mocked();

  MockedPort();

  /// What the adapter does with the cable's bytes; valid while it is plugged in.
  [[nodiscard]] int board() const { return board_; }

  void unplug();
  /// It comes back as ttyUSB`number`. \pre unplugged.
  void plug_in(int number);

  /// How often this process has switched DTR off.
  [[nodiscard]] static int dtr_falls();

 private:
  struct Unref {
    void operator()(UMockdevTestbed* testbed) const { g_object_unref(testbed); }
  };
  std::unique_ptr<UMockdevTestbed, Unref> testbed_;
  std::string name_;
  int board_ = -1;
  UniqueFd held_;  ///< The terminal that was unplugged.
};

}  // namespace slipstick::test
