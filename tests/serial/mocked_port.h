#pragma once

#include <umockdev.h>

#include <memory>
#include <string>

namespace slipstick::test {

/// A serial port that this machine does not have: `/dev/ttyUSB0`, a CH340 with its USB device, and
/// the other end of its cable. Only for programs under umockdev (see `mocked`).
class MockedPort {
 public:
  static constexpr const char* kPath = "/dev/ttyUSB0";

  /// Whether this process sees mocked devices: ctest's does, one started by hand does not.
  [[nodiscard]] static bool mocked();

  MockedPort();

  /// What the adapter does with the cable's bytes; valid as long as the port.
  [[nodiscard]] int board() const { return board_; }

  /// How often this process has switched DTR off.
  [[nodiscard]] static int dtr_falls();

 private:
  struct Unref {
    void operator()(UMockdevTestbed* testbed) const { g_object_unref(testbed); }
  };
  std::unique_ptr<UMockdevTestbed, Unref> testbed_;
  int board_;
};

}  // namespace slipstick::test
