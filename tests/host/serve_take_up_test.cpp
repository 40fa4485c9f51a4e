// A print of the daemon that was cut off by kill -9, and taken up over HTTP.
#include <signal.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/daemon_process.h"
#include "tests/support/http_client.h"
#include "tests/support/live_printer.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using namespace std::chrono_literals;
using Catch::Contains;
using nlohmann::json;

namespace {

class CutOffPrint {
 public:
  CutOffPrint() {
    std::string text;
    for (const std::string& line : program_) text += line + "\n";
    test::DaemonProcess daemon(data(), "pty:" + port_);
    REQUIRE(test::request(daemon.port(), "PUT", "/api/v1/files/a.gcode", text).status == 201);
    REQUIRE(test::request(daemon.port(), "POST", "/api/v1/jobs", R"({"file": "a.gcode"})").status ==
            201);
    until([&] { return printer_.count() >= 40; });
    CHECK(daemon.end(SIGKILL) == 128 + SIGKILL);
    REQUIRE(printer_.count() < 110);
  }

  std::filesystem::path data() const { return folder_.path() / "data"; }
  std::string address() const { return "pty:" + port_; }
  std::vector<test::Bead> beads() const { return test::without_speed(printer_.beads()); }
  std::vector<test::Bead> expected() const { return test::quick_beads(program_); }

  template <typename Condition>
  static void until(Condition condition) {
    for (int i = 0; i < 3000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
    REQUIRE(condition());
  }

 private:
  test::TemporaryFolder folder_;
  std::string port_ = (folder_.path() / "printer").string();
  std::vector<std::string> program_ = test::quick_program(120);
  test::LivePrinter printer_{port_};
};

json job(std::uint16_t port) {
  return json::parse(test::request(port, "GET", "/api/v1/jobs/1").body);
}

int take_up(std::uint16_t port, const std::string& body = "") {
  return test::request(port, "POST", "/api/v1/jobs/1/take-up", body).status;
}

}  // namespace

TEST_CASE(
    "A print of the daemon that was cut off is taken up once, and nothing is lost or repeated") {
  const CutOffPrint print;
  test::DaemonProcess daemon(print.data(), print.address());
  const std::uint16_t port = daemon.port();
  CHECK(job(port)["state"] == "interrupted");
  CHECK(job(port)["can_be_taken_up"] == true);
  CHECK(take_up(port, "[]") == 400);
  CHECK(take_up(port, R"({"more": true})") == 400);

  REQUIRE(take_up(port) == 204);

  CutOffPrint::until([&] { return job(port)["state"] == "done"; });
  CutOffPrint::until([&] { return print.beads().size() >= print.expected().size(); });
  CHECK(print.beads() == print.expected());
  CHECK(job(port)["can_be_taken_up"] == false);
  CHECK(take_up(port) == 409);
}

TEST_CASE("A print that cannot be taken up stays interrupted, and says why") {
  const CutOffPrint print;
  const test::LivePrinter other((print.data() / "other").string());
  test::DaemonProcess daemon(print.data(), "pty:" + (print.data() / "other").string());
  const std::uint16_t port = daemon.port();

  REQUIRE(take_up(port) == 204);

  CutOffPrint::until([&] {
    const json now = job(port);
    return now["state"] == "interrupted" && now["message"].get<std::string>().size() > 60;
  });
  CHECK_THAT(job(port)["message"].get<std::string>(), Contains("it can be recovered (--recover)"));
  CHECK(other.count() == 0);
  REQUIRE(test::request(port, "POST", "/api/v1/printer/bed-cleared").status == 204);
  CHECK(job(port)["can_be_taken_up"] == false);
  CHECK(take_up(port) == 409);
  CHECK(test::request(port, "POST", "/api/v1/jobs/9/take-up").status == 404);
}
