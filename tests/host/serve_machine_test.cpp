// Which printer there is: chosen over HTTP.
#include <catch2/catch.hpp>
#include <functional>

#include "tests/host/serve_fixture.h"
#include "tests/support/live_printer.h"

using namespace slipstick;
using namespace std::chrono_literals;
using nlohmann::json;

namespace {

std::string choice(const std::string& port, const std::string& machine) {
  return json{{"printer", port}, {"machine", machine}}.dump();
}

json machine(const test::RunningDaemon& daemon) {
  return test::json_of(daemon.get("/api/v1/machine"));
}

}  // namespace

TEST_CASE("A profile that is chosen is that of all jobs from then on, also after the next start") {
  test::RunningDaemon daemon;
  REQUIRE(machine(daemon)["machine"] == "generic_marlin");

  REQUIRE(daemon.put("/api/v1/machine", choice("sim:", "ender3")).status == 204);

  CHECK(machine(daemon)["machine"] == "ender3");
  daemon.restart();
  CHECK(machine(daemon)["machine"] == "ender3");
  const json settings = test::json_of(daemon.get("/api/v1/settings"))["settings"];
  CHECK(settings.dump().find("Ender") != std::string::npos);
}

TEST_CASE("What the command line says anew is newer than what was chosen before") {
  const PrinterChoice words{"/dev/ttyUSB0", "generic_marlin"};
  const PrinterChoice chosen{"/dev/ttyACM0", "ender3"};
  const test::TemporaryFolder folder;
  auto store = Store::open(folder.path());
  REQUIRE(store);
  REQUIRE(*store->printer_instead_of(words) == words);

  REQUIRE(store->choose_printer(chosen, words));

  CHECK(*store->printer_instead_of(words) == chosen);
  const PrinterChoice newer{"/dev/ttyUSB1", "generic_marlin"};
  CHECK(*store->printer_instead_of(newer) == newer);
}

TEST_CASE("No printer is chosen that is neither there nor known, and none while one prints") {
  test::RunningDaemon daemon;
  test::EventReader events(daemon);

  for (const std::string& body :
       {std::string(), std::string("{}"), std::string(R"({"printer": "sim:"})"),
        std::string(R"({"printer": 1, "machine": "ender3"})"), choice("pty:/etc/passwd", "ender3"),
        choice("tcp:127.0.0.1:80", "ender3"), choice("sim:", "../printers/ender3"),
        choice("sim:", "none"), choice("", "")}) {
    INFO(body);
    CHECK(daemon.put("/api/v1/machine", body).status == 400);
  }
  REQUIRE(daemon.put("/api/v1/files/part.lua", "return box(9, 9, 9)\n").status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "part.lua"})").status == 201);
  static_cast<void>(events.wait("state", [](const json& s) { return s["state"] == "printing"; }));
  REQUIRE(daemon.post("/api/v1/printer/pause").status == 204);
  static_cast<void>(events.wait("state", [](const json& s) { return s["state"] == "paused"; }));
  const auto late = daemon.put("/api/v1/machine", choice("sim:", "ender3"));

  CHECK(late.status == 409);
  CHECK(machine(daemon)["machine"] == "generic_marlin");
}

TEST_CASE("A printer that is left for another is left with its heaters off") {
  const test::TemporaryFolder folder;
  const std::string port = "pty:" + (folder.path() / "printer").string();
  test::LivePrinter printer(port.substr(4));
  StatusBoard board;
  EventLog events{[] {}};
  auto worker = *PrinterWorker::start({folder.path() / "data", port, {}}, board, events);
  const auto until = [](const std::function<bool()>& holds) {
    for (int i = 0; i < 6000 && !holds(); ++i) std::this_thread::sleep_for(10ms);
    REQUIRE(holds());
  };
  const auto target = [&] {
    const auto seen = board.get().temperatures;
    return seen && seen->hotend ? seen->hotend->target.value_or(-1) : -1.0;
  };
  until([&] { return board.get().connected; });
  REQUIRE(worker->say({"M104 S44", "M105"}));
  until([&] { return target() == 44; });

  REQUIRE(worker->use({"sim:", "ender3"}));

  until([&] { return !board.get().connected; });
  CHECK(worker->defaults().printer == "ender3");
  REQUIRE(worker->use({port, "ender3"}));
  until([&] { return board.get().connected && target() == 0; });
}
