#include "tests/serial/mocked_port.h"

#include <dlfcn.h>

#include "core/base/check.h"

// What is preloaded comes before the sanitizer, and calls it all the same.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "verify_asan_link_order=0";
}

namespace slipstick::test {
namespace {

// As `udevadm info` tells of such an adapter, the nearest first.
constexpr const char* kAdapter =
    "P: /devices/pci0000:00/0000:00:14.0/usb1/1-2\n"
    "N: bus/usb/001/004\n"
    "E: DEVNAME=/dev/bus/usb/001/004\n"
    "E: DEVTYPE=usb_device\n"
    "E: SUBSYSTEM=usb\n"
    "A: idVendor=1a86\n"
    "A: idProduct=7523\n"
    "A: busnum=1\n"
    "A: devnum=4\n"
    "A: product=USB Serial\n"
    "A: serial=A1B2\n"
    "\n"
    "P: /devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0\n"
    "E: DEVTYPE=usb_interface\n"
    "E: SUBSYSTEM=usb\n"
    "\n"
    "P: /devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0/ttyUSB0\n"
    "E: SUBSYSTEM=usb-serial\n"
    "\n"
    "P: /devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0/ttyUSB0/tty/ttyUSB0\n"
    "N: ttyUSB0\n"
    "E: DEVNAME=/dev/ttyUSB0\n"
    "E: SUBSYSTEM=tty\n"
    "A: dev=188:0\n"
    "L: device=../../../ttyUSB0\n"
    "\n";

// Of the modem lines, which are preloaded together with umockdev.
auto preloaded_dtr_falls() {
  return reinterpret_cast<int (*)()>(::dlsym(RTLD_DEFAULT, "slipstick_dtr_falls"));
}

}  // namespace

bool MockedPort::mocked() {
  return preloaded_dtr_falls() != nullptr;
}

MockedPort::MockedPort() : testbed_(umockdev_testbed_new()) {
  GError* error = nullptr;
  const bool added = umockdev_testbed_add_from_string(testbed_.get(), kAdapter, &error) != 0;
  SLIPSTICK_CHECK(added && error == nullptr);
  board_ = umockdev_testbed_get_dev_fd(testbed_.get(), kPath);
  SLIPSTICK_CHECK(board_ >= 0);
}

int MockedPort::dtr_falls() {
  return preloaded_dtr_falls()();
}

}  // namespace slipstick::test
