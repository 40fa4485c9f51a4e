#include "host/reconnect.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/support/temporary_folder.h"

using namespace slipstick;
using namespace std::chrono_literals;

namespace {

constexpr UsbId kCh340{0x1a86, 0x7523};

TransportAddress address_of(std::string_view text) {
  return *parse_transport_address(text);
}

SerialPort port(std::string path, std::string serial_number) {
  return {std::move(path), kCh340, "USB Serial", std::move(serial_number)};
}

/// A port that is not there, waited for next to no time.
struct Missing {
  explicit Missing(Moment patience_ = 1ms) : patience(patience_) {}

  const Moment patience;
  std::vector<std::string> told;
  bool ended = false;
  ReturningPort port{address_of("/dev/no-such-port"),
                     {[this](const std::string& text) { told.push_back(text); },
                      [this] { return ended; }, patience}};
};

constexpr ErrorCode kLost = ErrorCode::kDisconnected;

}  // namespace

TEST_CASE("A device that has a serial number is looked for by it, on any port") {
  const std::vector<SerialPort> ports{port("/dev/ttyUSB0", "A1"), port("/dev/ttyUSB1", "B2")};

  CHECK(lasting_address(address_of("/dev/ttyUSB1?baud=250000"), ports) ==
        address_of("usb:1a86:7523:B2?baud=250000"));
}

TEST_CASE("A device that nothing tells from others is looked for where it was") {
  const auto address = address_of("/dev/ttyUSB0");
  const auto here = [&](const std::vector<SerialPort>& ports) {
    return lasting_address(address, ports) == address;
  };
  CHECK(here({}));
  CHECK(here({port("/dev/ttyUSB0", "")}));
  CHECK(here({port("/dev/ttyUSB0", "A1"), port("/dev/ttyUSB1", "A1")}));
  CHECK(here({SerialPort{"/dev/ttyUSB0", std::nullopt, "", "A1"}}));
  for (const char* other : {"usb:1a86:7523", "pty:/dev/ttyUSB0", "tcp:localhost:23"}) {
    CHECK(lasting_address(address_of(other), {port("/dev/ttyUSB0", "A1")}) == address_of(other));
  }
}

TEST_CASE("A port that does not come back is not waited for for ever, nor against anybody's will") {
  Missing missing;
  CHECK_FALSE(missing.port.comes_back());
  CHECK(missing.port.returns() == 0);
  CHECK(missing.told.size() == 1);

  Missing unwanted(ReturningPort::kPatience);
  unwanted.ended = true;
  CHECK_FALSE(unwanted.port.comes_back());
}

TEST_CASE("Only a port that went away in a print is waited for") {
  Missing missing;
  CHECK(missing.port.lost({kLost, ""}));
  for (const ErrorCode code : {ErrorCode::kInput, ErrorCode::kUnavailable, ErrorCode::kTimedOut,
                               ErrorCode::kCancelled, ErrorCode::kPrinter}) {
    CHECK_FALSE(missing.port.lost({code, ""}));
  }
  CHECK_FALSE(ReturningPort(address_of("sim:"), {}).lost({kLost, ""}));
  CHECK(missing.port.met({ErrorCode::kUnavailable, ""}).code == ErrorCode::kUnavailable);
}

TEST_CASE("Without a journal nothing is attempted again") {
  const test::TemporaryFolder folder;
  Missing missing;
  int attempts = 0;

  const auto done = print_through_gaps(missing.port, folder.path() / "none.journal",
                                       [&](const std::optional<JournalContent>&) -> Result<int> {
                                         ++attempts;
                                         return fail(kLost, "the cable is out");
                                       });

  CHECK(attempts == 1);
  CHECK(missing.told.empty());
  CHECK(done.error().message == "the cable is out");
}

TEST_CASE("A port that comes back as often as it goes is given up at last") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.journal";
  std::ofstream(path) << header_record({});
  int told = 0;
  // Whatever can be opened is a port that is back.
  ReturningPort port(address_of("pty:/dev/ptmx"),
                     {[&](const std::string&) { ++told; }, [] { return false; }, 10s, 1ms});
  int attempts = 0;

  const auto done =
      print_through_gaps(port, path, [&](const std::optional<JournalContent>& rest) -> Result<int> {
        CHECK(rest.has_value() == (attempts++ > 0));
        return fail(kLost, "the cable is out");
      });

  CHECK_FALSE(done);
  CHECK(attempts == 1 + ReturningPort::kReturnsMax);
  CHECK(told == 2 * ReturningPort::kReturnsMax);
  CHECK(port.met({ErrorCode::kUnavailable, ""}).code == kLost);
  CHECK(port.met({ErrorCode::kInput, ""}).code == ErrorCode::kInput);
}
