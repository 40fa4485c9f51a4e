// The serial port of a board behind a USB adapter, mocked by umockdev, with the simulated printer
// at its other end.
#include <asm/termbits.h>
#include <sys/ioctl.h>

#include <array>
#include <catch2/catch.hpp>
#include <thread>

#include "drivers/open_transport.h"
#include "drivers/serial_ports.h"
#include "drivers/serial_transport.h"
#include "host/stream_job.h"
#include "tests/serial/board.h"
#include "tests/support/live_printer.h"

using namespace slipstick;
using namespace std::chrono_literals;
using Catch::Contains;
using test::Board;
using test::MockedPort;

namespace {

termios2 settings_of(int terminal) {
  termios2 settings{};
  REQUIRE(::ioctl(terminal, TCGETS2, &settings) == 0);
  return settings;
}

/// A host twenty times as hasty as a real one.
class HastyClock final : public Clock {
 public:
  [[nodiscard]] Moment now() const override { return 20 * SteadyClock().now(); }
};

Result<StreamOutcome> print(Transport& transport, const std::vector<std::string>& program) {
  const HastyClock clock;
  test::ProgramLines lines(program);
  return stream_job(transport, clock, lines, {});
}

}  // namespace

TEST_CASE("A serial port is listed with its adapter, and found by it") {
  if (test::skipped()) return;
  const MockedPort port;

  const auto ports = list_serial_ports();

  REQUIRE(ports);
  REQUIRE(ports->size() == 1);
  CHECK(ports->front() == SerialPort{.path = MockedPort::kPath,
                                     .usb = UsbId{0x1a86, 0x7523},
                                     .product = "USB Serial",
                                     .serial_number = "A1B2"});
  CHECK(find_serial_port(*ports, {0x1a86, 0x7523}, "A1B2") == MockedPort::kPath);
}

TEST_CASE("A serial port is opened raw, at any baud rate") {
  if (test::skipped()) return;
  for (const int baud : {115'200, 250'000, 1'000'000}) {
    INFO(baud);
    const MockedPort port;

    const auto transport = open_serial(MockedPort::kPath, baud);

    if (!transport) FAIL(transport.error().message);
    const termios2 settings = settings_of(port.board());
    CHECK(settings.c_ospeed == static_cast<speed_t>(baud));
    CHECK((settings.c_lflag & (ICANON | ECHO | ISIG)) == 0);
    CHECK((settings.c_oflag & OPOST) == 0);
    CHECK((settings.c_iflag & (IXON | IXOFF | ICRNL)) == 0);
  }
}

TEST_CASE("A serial port that is closed keeps DTR, so that the next opening resets no board") {
  if (test::skipped()) return;
  const MockedPort port;
  const int falls = MockedPort::dtr_falls();

  for (const int baud : {115'200, 250'000}) {
    REQUIRE(open_serial(MockedPort::kPath, baud));

    CHECK((settings_of(port.board()).c_cflag & HUPCL) == 0);
  }
  CHECK(MockedPort::dtr_falls() == falls);
}

TEST_CASE("A print goes out over a serial port") {
  if (test::skipped()) return;
  MockedPort port;
  std::vector<test::Bead> beads;
  const auto program = test::quick_program(300);
  {
    const Board board(port, Printer({}, test::into(beads)));
    const auto transport = open_transport(*parse_transport_address("usb:1a86:7523"));
    REQUIRE(transport);

    const auto outcome = print(**transport, program);

    REQUIRE(outcome);
    std::this_thread::sleep_for(500ms);  // until the last moves are over
  }
  CHECK(test::without_speed(beads) == test::quick_beads(program));
}

TEST_CASE("A board that answers nothing is reset by DTR, and then prints") {
  if (test::skipped()) return;
  MockedPort port;
  Printer halted({});
  halted.advance(1s);
  halted.kill();
  for (std::array<char, 512> words{}; halted.take(words) > 0;) continue;  // nobody heard it
  const int falls = MockedPort::dtr_falls();
  const Board board(port, std::move(halted));
  const auto transport = open_serial(MockedPort::kPath, 115'200);
  REQUIRE(transport);

  const auto outcome = print(**transport, {"M105", "G28"});

  CHECK(outcome);
  CHECK(MockedPort::dtr_falls() == falls + 1);
}

TEST_CASE("A port that is no serial port is refused by name") {
  if (test::skipped()) return;
  const MockedPort port;

  const auto transport = open_serial("/dev/ttyUSB7", 115'200);

  REQUIRE_FALSE(transport);
  CHECK_THAT(transport.error().message, Contains("/dev/ttyUSB7"));
}
