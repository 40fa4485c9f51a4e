#include "tests/serial/mocked_port.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "core/base/check.h"

// What is preloaded comes before the sanitizer, and calls it all the same.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "verify_asan_link_order=0";
}

namespace slipstick::test {
namespace {

const std::string kUsbDevice = "/sys/devices/pci0000:00/0000:00:14.0/usb1/1-2";

// As `udevadm info` tells of such an adapter, the nearest to the computer first.
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
    "P: /devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0/{0}\n"
    "E: SUBSYSTEM=usb-serial\n"
    "\n"
    "P: /devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0/{0}/tty/{0}\n"
    "N: {0}\n"
    "E: DEVNAME=/dev/{0}\n"
    "E: SUBSYSTEM=tty\n"
    "A: dev=188:0\n"
    "L: device=../../../{0}\n"
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
  plug_in(0);
}

void MockedPort::plug_in(int number) {
  SLIPSTICK_CHECK(board_ < 0);
  name_ = fmt::format("ttyUSB{}", number);
  const std::string adapter = fmt::format(kAdapter, name_);
  const std::string path = "/dev/" + name_;
  SLIPSTICK_CHECK(umockdev_testbed_add_from_string(testbed_.get(), adapter.c_str(), nullptr) != 0);
  board_ = umockdev_testbed_get_dev_fd(testbed_.get(), path.c_str());
  // A program that is started here must not hold its own cable.
  SLIPSTICK_CHECK(board_ >= 0 && ::fcntl(board_, F_SETFD, FD_CLOEXEC) == 0);
}

void MockedPort::unplug() {
  // One by one: what stands in /sys/bus of a device's children is not removed with it.
  for (const char* below : {"/1-2:1.0/{0}/tty/{0}", "/1-2:1.0/{0}", "/1-2:1.0", ""}) {
    const std::string device = fmt::format(fmt::runtime(below), name_);
    umockdev_testbed_remove_device(testbed_.get(), (kUsbDevice + device).c_str());
  }
  // umockdev knows terminals by their numbers: the next must not get that of this one.
  held_ = UniqueFd(::ioctl(board_, TIOCGPTPEER, O_RDWR | O_NOCTTY));
  SLIPSTICK_CHECK(held_.get() >= 0);
  ::close(board_);
  board_ = -1;
}

int MockedPort::dtr_falls() {
  return preloaded_dtr_falls()();
}

}  // namespace slipstick::test
