// The printer of a daemon between prints.
#include <catch2/catch.hpp>

#include "host/serve/idle_connection.h"
#include "sim/sim_transport.h"
#include "tests/host/serve_fixture.h"
#include "tests/support/live_printer.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

/// A daemon whose printer is a terminal away, and somebody who listens to its events.
struct Workshop {
  json connected(bool wanted) {
    return events.wait("state", [&](const json& s) { return s["connected"] == wanted; });
  }
  bool nozzle_is_to_be(int celsius) {
    return !events
                .wait("temperatures",
                      [&](const json& seen) { return seen["nozzle"]["target"] == celsius; })
                .is_null();
  }
  int say(const std::string& command) const {
    return daemon
        .post("/api/v1/printer/commands", json{{"commands", json::array({command})}}.dump())
        .status;
  }

  test::TemporaryFolder folder;
  std::string port = (folder.path() / "printer").string();
  test::LivePrinter printer{port};
  test::RunningDaemon daemon{"pty:" + port};
  test::EventReader events{daemon};
};

}  // namespace

TEST_CASE("Between prints a printer is connected, heard, and told what is said, and then prints") {
  Workshop shop;
  CHECK_THAT(shop.connected(true)["firmware"].get<std::string>(), Contains("Marlin"));

  CHECK(shop.say("M104 S41") == 204);
  CHECK(shop.nozzle_is_to_be(41));
  CHECK(shop.daemon.post("/api/v1/printer/adjust", R"({"nozzle": 42})").status == 204);
  CHECK(shop.nozzle_is_to_be(42));
  CHECK(shop.daemon.post("/api/printer/printhead", R"({"command": "jog", "x": 5})").status == 204);
  CHECK(shop.daemon.post("/api/printer/printhead", R"({"command": "jog"})").status == 400);
  // Not done, as the nozzle is cold, which would pause a print.
  CHECK(shop.daemon.post("/api/printer/tool", R"({"command": "extrude", "amount": 5})").status ==
        204);
  CHECK(shop.say("M112") == 400);
  CHECK(shop.say("G1 X\u00fc") == 400);

  const auto program = test::quick_program(30);
  std::string text;
  for (const std::string& line : program) text += line + "\n";
  REQUIRE(shop.daemon.put("/api/v1/files/a.gcode", text).status == 201);
  REQUIRE(shop.daemon.post("/api/v1/jobs", R"({"file": "a.gcode"})").status == 201);
  CHECK(shop.events.wait_for_rest()["state"] == "idle");
  CHECK(shop.connected(true)["bed_occupied"] == true);
  CHECK(test::without_speed(shop.printer.beads()) == test::quick_beads(program));
}

TEST_CASE("A daemon that ends leaves no heater on that was switched on between prints") {
  Workshop shop;
  static_cast<void>(shop.connected(true));
  REQUIRE(shop.say("M104 S43") == 204);
  REQUIRE(shop.nozzle_is_to_be(43));

  shop.daemon.stop();

  const test::RunningDaemon next("pty:" + shop.port);
  test::EventReader events(next);
  const json seen = events.wait("temperatures", [](const json&) { return true; });
  CHECK(seen["nozzle"]["target"] == 0);
}

TEST_CASE("An emergency stop between prints reaches the printer, which is left alone after that") {
  Workshop shop;
  static_cast<void>(shop.connected(true));

  REQUIRE(shop.daemon.post("/api/v1/printer/emergency-stop").status == 204);

  const json state =
      shop.events.wait("state", [](const json& s) { return s["state"] == "stopped"; });
  CHECK(state["connected"] == false);
  CHECK_THAT(state["message"].get<std::string>(), Contains("emergency stop"));
  CHECK(shop.say("M104 S41") == 409);
}

TEST_CASE("A printer that falls silent between prints is not said to be there for ever") {
  SimTransport sim(*sim_options({{"fault", "mute@line6"}}));
  PrintControl control;

  const auto how = stay_connected(sim, sim.clock(), control, [] { return false; });

  REQUIRE_FALSE(how);
  CHECK(how.error().code == ErrorCode::kPrinter);
  CHECK(sim.clock().now() < std::chrono::minutes(10));
}

TEST_CASE("A job that fails before it was sent leaves the printer in sight") {
  Workshop shop;
  static_cast<void>(shop.connected(true));
  REQUIRE(shop.daemon.put("/api/v1/files/a.gcode", "G28\nM112\n").status == 201);

  REQUIRE(shop.daemon.post("/api/v1/jobs", R"({"file": "a.gcode"})").status == 201);

  CHECK(shop.events.wait_for_rest()["state"] == "stopped");
  CHECK(shop.connected(true)["state"] == "idle");
}

TEST_CASE("Documents that are nested too deeply are refused wherever one is asked for") {
  const test::RunningDaemon daemon;
  const std::string deep = std::string(400'000, '[') + std::string(400'000, ']');
  for (const char* path : {"/api/v1/printer/commands", "/api/v1/jobs", "/api/job",
                           "/api/printer/command", "/api/v1/printer/adjust"}) {
    CAPTURE(path);
    CHECK(daemon.post(path, R"({"commands": )" + deep + "}").status == 400);
    CHECK(daemon.post(path, deep).status == 400);
  }
}

TEST_CASE("A printer that is not there is said to be missing, and does not hold the daemon up") {
  const test::TemporaryFolder folder;
  test::RunningDaemon daemon("pty:" + (folder.path() / "none").string());
  test::EventReader events(daemon);

  const json state = events.wait("state", [](const json& s) { return s["message"] != ""; });

  CHECK_THAT(state["message"].get<std::string>(), Contains("none: cannot open"));
  CHECK(daemon.post("/api/v1/printer/adjust", R"({"nozzle": 42})").status == 409);
}
