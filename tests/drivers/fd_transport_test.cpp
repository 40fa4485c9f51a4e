#include "drivers/fd_transport.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <thread>

#include "drivers/clock.h"
#include "drivers/open_transport.h"
#include "drivers/pty_transport.h"
#include "drivers/serial_transport.h"
#include "drivers/tcp_transport.h"

namespace slipstick {
namespace {

using namespace std::chrono_literals;

/// One end as a transport, the other as a bare descriptor.
struct Pair {
  Pair() {
    std::array<int, 2> ends{};
    REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0);
    far = UniqueFd(ends[1]);
    near = *FdTransport::adopt(UniqueFd(ends[0]), "test:pair");
  }
  std::unique_ptr<FdTransport> near;
  UniqueFd far;
};

std::string read_once(Transport& transport, Moment patience = 5s) {
  std::array<char, 64> buffer{};
  const auto count = transport.read_some(buffer, patience);
  return count ? std::string(buffer.data(), *count) : count.error().message;
}

ErrorCode read_error(Transport& transport, Moment patience = 5s) {
  std::array<char, 64> buffer{};
  const auto count = transport.read_some(buffer, patience);
  REQUIRE_FALSE(count);
  return count.error().code;
}

TEST_CASE("Bytes go both ways as they are") {
  Pair pair;
  std::array<char, 8> heard{};

  REQUIRE(pair.near->write_all("M105\n", 5s));
  REQUIRE(::read(pair.far.get(), heard.data(), heard.size()) == 5);
  REQUIRE(::write(pair.far.get(), "ok\n", 3) == 3);

  CHECK(std::string_view(heard.data(), 5) == "M105\n");
  CHECK(read_once(*pair.near) == "ok\n");
}

TEST_CASE("Nothing in time is kTimedOut, and the stream is still good") {
  Pair pair;

  CHECK(read_error(*pair.near, 0us) == ErrorCode::kTimedOut);
  REQUIRE(::write(pair.far.get(), "x", 1) == 1);
  CHECK(read_once(*pair.near) == "x");
}

TEST_CASE("A peer that does not read lets a write time out") {
  Pair pair;
  const std::string much(4 << 20, 'x');

  const auto written = pair.near->write_all(much, 1ms);

  REQUIRE_FALSE(written);
  CHECK(written.error().code == ErrorCode::kTimedOut);
}

TEST_CASE("A peer that is gone is kUnavailable for reading and writing, and kills nobody") {
  Pair pair;
  pair.far = UniqueFd();

  CHECK(read_error(*pair.near) == ErrorCode::kUnavailable);
  CHECK(read_error(*pair.near) == ErrorCode::kUnavailable);
  const auto written = pair.near->write_all("x", 5s);
  REQUIRE_FALSE(written);
  CHECK(written.error().code == ErrorCode::kUnavailable);
  CHECK(written.error().message ==
        "test:pair: Broken pipe; check the cable and the power, then connect again");
}

TEST_CASE("shut_down from another thread ends a read in progress and all later calls") {
  Pair pair;
  std::thread other([&] { pair.near->shut_down(); });

  const ErrorCode code = read_error(*pair.near, 1h);
  other.join();
  pair.near->shut_down();

  CHECK(code == ErrorCode::kCancelled);
  CHECK(read_error(*pair.near) == ErrorCode::kCancelled);
  CHECK(pair.near->write_all("x", 5s).error().code == ErrorCode::kCancelled);
}

TEST_CASE("A pseudo-terminal is opened raw: no echo, no translation, and its end is noticed") {
  UniqueFd master(::posix_openpt(O_RDWR | O_NOCTTY));
  REQUIRE(master.get() >= 0);
  REQUIRE(::grantpt(master.get()) == 0);
  REQUIRE(::unlockpt(master.get()) == 0);
  const std::string path = ::ptsname(master.get());

  auto opened = open_transport(*parse_transport_address("pty:" + path));
  REQUIRE(opened);
  Transport& transport = **opened;
  REQUIRE(::write(master.get(), "ok\r\n\x03", 5) == 5);

  CHECK(read_once(transport) == "ok\r\n\x03");
  auto printer = FdTransport::adopt(std::move(master), "test:master");
  CHECK(read_error(**printer, 0us) == ErrorCode::kTimedOut);
  REQUIRE(transport.write_all("M105\n", 5s));
  CHECK(read_once(**printer) == "M105\n");
  printer->reset();
  CHECK(read_error(transport) == ErrorCode::kUnavailable);
  CHECK(transport.name() == "pty:" + path);
}

TEST_CASE("What cannot be opened says why") {
  CHECK(open_pty("/nonexistent").error().message ==
        "pty:/nonexistent: cannot open it as a terminal: No such file or directory");
  CHECK(open_pty("/dev/null").error().code == ErrorCode::kUnavailable);
  CHECK(open_serial("/dev/nonexistent", 115200).error().code == ErrorCode::kUnavailable);
}

TEST_CASE(
    "A network printer is reached by name on this machine, and a closed port is unavailable") {
  UniqueFd listener(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in place{};
  socklen_t size = sizeof place;
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* const address = reinterpret_cast<sockaddr*>(&place);
  REQUIRE(::bind(listener.get(), address, size) == 0);
  REQUIRE(::listen(listener.get(), 1) == 0);
  REQUIRE(::getsockname(listener.get(), address, &size) == 0);
  const std::uint16_t port = ntohs(place.sin_port);

  auto opened = open_tcp("127.0.0.1", port, 5s);
  REQUIRE(opened);
  UniqueFd printer(::accept(listener.get(), nullptr, nullptr));
  REQUIRE(::write(printer.get(), "start\n", 6) == 6);

  CHECK(read_once(**opened) == "start\n");
  listener = UniqueFd();
  printer = UniqueFd();
  CHECK(read_error(**opened) == ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace slipstick
