// kill -9 at moments drawn from a seed: nothing that was accepted is lost, nothing is printed
// twice. SLIPSTICK_KILLS=100 for as many; SLIPSTICK_SEED=S for another voyage.
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/rng.h"
#include "drivers/unique_fd.h"
#include "tests/support/daemon_process.h"
#include "tests/support/environment.h"
#include "tests/support/http_client.h"
#include "tests/support/obedient_printer.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using nlohmann::json;

namespace {

std::string name_of(std::uint64_t number) {
  return "part" + std::to_string(number) + ".gcode";
}

// A program that says whose it is, and is long enough to be cut off.
std::string program(std::uint64_t number) {
  std::string text = "M117 part" + std::to_string(number) + "\n";
  for (int i = 0; i < 400; ++i) text += "G1 X" + std::to_string(i % 9) + "\n";
  return text;
}

// Lets the daemon go on, by as many requests as it takes.
template <typename Done>
void ask_until(std::uint16_t port, Done done) {
  for (int i = 0; i < 20'000 && !done(); ++i) {
    REQUIRE(test::request(port, "GET", "/api/v1/printer").status == 200);
  }
  REQUIRE(done());
}

class Voyage {
 public:
  explicit Voyage(std::uint64_t seed) : rng_(seed) {}

  // Some requests, then the end in the middle of one more.
  void live_and_die() {
    test::DaemonProcess daemon(folder_.path(), printer_.address());
    const std::uint64_t requests = rng_.below(8);
    for (std::uint64_t i = 0; i < requests; ++i) act(daemon.port());
    test::HttpClient last(daemon.port());
    last.send(text_of("PUT", "/api/v1/files/" + name_of(files_ + 1), program(files_ + 1))
                  .substr(0, 1 + rng_.below(6000)));
    ++files_;
    // So many commands later, without looking at a clock; at once if nothing is printed.
    const std::size_t enough = printer_.commands().size() + rng_.below(200);
    for (int i = 0; i < 20'000 && printer_.commands().size() < enough; ++i) {
      const auto now = test::request(daemon.port(), "GET", "/api/v1/printer");
      if (json::parse(now.body)["state"] != "printing") break;
    }
    CHECK(daemon.end(SIGKILL) == 128 + SIGKILL);
  }

  void check_all() {
    test::DaemonProcess daemon(folder_.path(), printer_.address());
    const auto listed = test::request(daemon.port(), "GET", "/api/v1/files");
    std::map<std::string, std::size_t> sizes;
    const json files = json::parse(listed.body)["files"];
    for (const json& file : files) {
      sizes[file["name"]] = file["size"];
    }
    for (const std::uint64_t number : accepted_files_) {
      INFO(name_of(number));
      CHECK(sizes[name_of(number)] == program(number).size());
    }
    for (const auto& [job, number] : accepted_jobs_) check_job(daemon.port(), job, number);
    CHECK(printed_ > 0);  // or the voyage shows nothing
    CHECK(interrupted_ > 0);
    CHECK(daemon.end(SIGTERM) == 0);
  }

 private:
  static std::string text_of(const std::string& method, const std::string& target,
                             const std::string& body) {
    return method + " " + target +
           " HTTP/1.1\r\nHost: localhost\r\nContent-Length: " + std::to_string(body.size()) +
           "\r\n\r\n" + body;
  }

  void act(std::uint16_t port) {
    const std::uint64_t what = rng_.below(3);
    if (what == 0 || accepted_files_.empty()) {
      const std::uint64_t number = ++files_;
      const auto reply =
          test::request(port, "PUT", "/api/v1/files/" + name_of(number), program(number));
      REQUIRE(reply.status == 201);
      accepted_files_.push_back(number);
      unprinted_.push_back(number);
    } else if (what == 1 && !unprinted_.empty()) {
      const std::uint64_t number = unprinted_.back();
      unprinted_.pop_back();
      queue(port, number);
    } else {
      static_cast<void>(test::request(port, "POST", "/api/v1/printer/bed-cleared"));
    }
  }

  void queue(std::uint16_t port, std::uint64_t number) {
    const json job{{"file", name_of(number)}};
    const auto reply = test::request(port, "POST", "/api/v1/jobs", job.dump());
    REQUIRE(reply.status == 201);
    accepted_jobs_[json::parse(reply.body)["id"].get<std::int64_t>()] = number;
  }

  void check_job(std::uint16_t port, std::int64_t id, std::uint64_t number) {
    const auto reply = test::request(port, "GET", "/api/v1/jobs/" + std::to_string(id));
    INFO("job " << id << ": " << reply.body);
    REQUIRE(reply.status == 200);
    const std::string state = json::parse(reply.body)["state"];
    const auto commands = printer_.commands();
    const auto times =
        std::count(commands.begin(), commands.end(), "M117 part" + std::to_string(number));
    CHECK(times <= 1);
    printed_ += times;
    if (state == "interrupted") ++interrupted_;
    if (state == "done") CHECK(times == 1);
    if (state == "queued") CHECK(times == 0);
    CHECK((state == "queued" || state == "done" || state == "interrupted" || state == "printing"));
  }

  test::TemporaryFolder folder_;
  test::ObedientPrinter printer_;
  Rng rng_;
  std::uint64_t files_ = 0;
  std::int64_t printed_ = 0;
  std::int64_t interrupted_ = 0;
  std::vector<std::uint64_t> accepted_files_;
  std::vector<std::uint64_t> unprinted_;                 // accepted and in no job yet
  std::map<std::int64_t, std::uint64_t> accepted_jobs_;  // to their files
};

}  // namespace

TEST_CASE("Killed at any moment, the daemon loses nothing it accepted and prints nothing twice") {
  const std::uint64_t seed = test::from_environment("SLIPSTICK_SEED", 1);
  const std::uint64_t kills = test::from_environment("SLIPSTICK_KILLS", 6);
  INFO("SLIPSTICK_SEED=" << seed << " SLIPSTICK_KILLS=" << kills);
  Voyage voyage(seed);

  for (std::uint64_t i = 0; i < kills; ++i) voyage.live_and_die();

  voyage.check_all();
}

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
