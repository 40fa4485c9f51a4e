#include "drivers/transport_address.h"

#include <catch2/catch.hpp>

#include "drivers/serial_ports.h"

namespace slipstick {
namespace {

TransportAddress parsed(std::string_view text) {
  auto address = parse_transport_address(text);
  INFO(text);
  REQUIRE(address);
  return *address;
}

TEST_CASE("Every form of address is understood") {
  CHECK(parsed("/dev/ttyUSB0").kind == TransportKind::kSerial);
  CHECK(parsed("/dev/ttyUSB0").target == "/dev/ttyUSB0");
  CHECK(baud_rate(parsed("/dev/ttyUSB0")) == 115200);
  CHECK(baud_rate(parsed("/dev/ttyUSB0?baud=250000")) == 250000);
  const auto usb = parsed("usb:1a86:7523:A5:6?baud=500000");
  CHECK(usb.kind == TransportKind::kUsb);
  CHECK(usb.vendor_id == 0x1a86);
  CHECK(usb.product_id == 0x7523);
  CHECK(usb.target == "A5:6");
  CHECK(parsed("usb:1A86:7523").target.empty());
  CHECK(parsed("pty:/tmp/printer").target == "/tmp/printer");
  CHECK(parsed("tcp:localhost:2323").target == "localhost");
  CHECK(parsed("tcp:[::1]:23").target == "::1");
  CHECK(parsed("tcp:10.0.0.2:8080").port == 8080);
  CHECK(parsed("sim:").options.empty());
  CHECK(parsed("sim:?seed=7&corrupt=0.002").options.at("corrupt") == "0.002");
}

TEST_CASE("A wrong address says what is wrong with it") {
  CHECK(parse_transport_address("ttyUSB0").error().message ==
        "port 'ttyUSB0': not one of /dev/NAME, usb:VID:PID, pty:PATH, tcp:HOST:PORT, sim:");
  CHECK(parse_transport_address("/dev/ttyUSB0?speed=1").error().message ==
        "port '/dev/ttyUSB0?speed=1': there is no option 'speed' for this kind of port");
  CHECK(parse_transport_address("/dev/ttyUSB0?baud=fast").error().message ==
        "port 'baud=fast': a baud rate is from 1200 to 4000000, usually 115200 or 250000");
  for (const std::string_view bad :
       {"", "tcp:", "tcp:host", "tcp::23", "tcp:host:0", "tcp:host:65536", "tcp:host:23x",
        "usb:", "usb:1a86", "usb:xyz:7523", "usb:1a86:17523", "pty:", "sim:fast", "sim:?seed",
        "sim:?seed=1&seed=2", "sim:?=1", "pty:/tmp/p?baud=1200",
        "/dev/x?baud=", "/dev/x?baud=300"}) {
    INFO(bad);
    const auto address = parse_transport_address(bad);
    REQUIRE_FALSE(address);
    CHECK(address.error().code == ErrorCode::kInput);
  }
  CHECK_FALSE(parse_transport_address("/" + std::string(2000, 'x')));
}

TEST_CASE("A USB adapter is found only when it is the only one") {
  const std::vector<SerialPort> ports{{"/dev/ttyS0", {}, "", ""},
                                      {"/dev/ttyUSB0", UsbId{0x1a86, 0x7523}, "CH340", "A"},
                                      {"/dev/ttyUSB1", UsbId{0x1a86, 0x7523}, "CH340", "B"},
                                      {"/dev/ttyACM0", UsbId{0x2c99, 2}, "MK3", "C"}};

  CHECK(find_serial_port(ports, {0x2c99, 2}, "") == "/dev/ttyACM0");
  CHECK(find_serial_port(ports, {0x1a86, 0x7523}, "B") == "/dev/ttyUSB1");
  CHECK(find_serial_port(ports, {0x1a86, 0x7523}, "").error().message ==
        "usb:1a86:7523: 2 adapters have these ids; name one by its /dev path or add its serial "
        "number");
  CHECK(find_serial_port(ports, {0x1a86, 0x7523}, "Z").error().message ==
        "usb:1a86:7523:Z: no such adapter; is it plugged in and switched on?");
}

}  // namespace
}  // namespace slipstick
