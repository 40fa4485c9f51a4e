// The daemon as a process: how it ends, and what it tells systemd and its printer.
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "drivers/unique_fd.h"
#include "tests/support/daemon_process.h"
#include "tests/support/http_client.h"
#include "tests/support/obedient_printer.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using nlohmann::json;

namespace {

// Lets the daemon go on, by as many requests as it takes.
template <typename Done>
void ask_until(std::uint16_t port, Done done) {
  for (int i = 0; i < 20'000 && !done(); ++i) {
    REQUIRE(test::request(port, "GET", "/api/v1/printer").status == 200);
  }
  REQUIRE(done());
}

}  // namespace

TEST_CASE("A print that was cut off leaves a printer that is told to cool down") {
  const test::TemporaryFolder folder;
  test::ObedientPrinter printer;
  const auto hot = [&] {
    const auto commands = printer.commands();
    return std::count(commands.begin(), commands.end(), "M104 S210");
  };
  {
    test::DaemonProcess daemon(folder.path(), printer.address());
    std::string program = "M104 S210\n";
    for (int i = 0; i < 100'000; ++i) program += "G1 X" + std::to_string(i % 9) + "\n";
    REQUIRE(test::request(daemon.port(), "PUT", "/api/v1/files/a.gcode", program).status == 201);
    REQUIRE(test::request(daemon.port(), "POST", "/api/v1/jobs", R"({"file": "a.gcode"})").status ==
            201);
    ask_until(daemon.port(), [&] { return hot() > 0; });
    daemon.end(SIGKILL);
  }
  CHECK(printer.commands().back() != "M84 S0");

  test::DaemonProcess daemon(folder.path(), printer.address());

  const auto job = test::request(daemon.port(), "GET", "/api/v1/jobs/1");
  CHECK(json::parse(job.body)["state"] == "interrupted");
  ask_until(daemon.port(), [&] { return printer.commands().back() == "M84 S0"; });
  const auto commands = printer.commands();
  CHECK(std::count(commands.begin(), commands.end(), "M104 S0") == 1);
  CHECK(std::count(commands.begin(), commands.end(), "M140 S0") == 1);
  CHECK(hot() == 1);
  CHECK(std::count(commands.begin(), commands.end(), "M84") == 0);  // or it could not be taken up
}

TEST_CASE("systemd is told when the daemon is ready, alive and stopping") {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "manager").string();
  const UniqueFd manager(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  REQUIRE(::bind(manager.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
  const auto told = [&] {
    char text[256];
    const ssize_t size = ::recv(manager.get(), text, sizeof text, 0);
    return std::string(text, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  };
  ::setenv("NOTIFY_SOCKET", path.c_str(), 1);
  test::DaemonProcess daemon(folder.path() / "data", "sim:");
  ::unsetenv("NOTIFY_SOCKET");

  CHECK(told() == "READY=1");
  CHECK(told() == "WATCHDOG=1");
  CHECK(daemon.end(SIGTERM) == 0);

  std::string last = told();
  while (last == "WATCHDOG=1") last = told();
  CHECK(last == "STOPPING=1");
}

TEST_CASE("SIGTERM during a print ends it with the heaters off, and status 0") {
  const test::TemporaryFolder folder;
  test::ObedientPrinter printer;
  test::DaemonProcess daemon(folder.path(), printer.address());
  std::string program = "M104 S210\n";
  for (int i = 0; i < 100'000; ++i) program += "G1 X" + std::to_string(i % 9) + "\n";
  REQUIRE(test::request(daemon.port(), "PUT", "/api/v1/files/a.gcode", program).status == 201);
  REQUIRE(test::request(daemon.port(), "POST", "/api/v1/jobs", R"({"file": "a.gcode"})").status ==
          201);
  ask_until(daemon.port(), [&] { return printer.commands().size() >= 20; });

  CHECK(daemon.end(SIGTERM) == 0);

  const auto commands = printer.commands();
  CHECK(std::count(commands.begin(), commands.end(), "M104 S0") >= 1);
  CHECK(std::count(commands.begin(), commands.end(), "M84") >= 1);
}
