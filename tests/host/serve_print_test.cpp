// From an upload over HTTP to a printed part on the simulated printer.
#include <catch2/catch.hpp>

#include "tests/host/serve_fixture.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

constexpr const char* kSmall = R"({"file": "part.lua", "spec": {"placement": {"fit": [12, 12, 6]},
    "settings": {"layer_height": 0.3, "first_layer_height": 0.3, "certify": "off"}}})";
constexpr const char* kTall = R"({"file": "part.lua", "spec": {"placement": {"fit": [60, 60, 60]},
    "settings": {"certify": "off"}}})";

std::string moves(int count) {
  std::string text = "G90\nM83\nG92 X0 Y0\n";
  for (int i = 0; i < count; ++i) text += "G1 X" + std::to_string(i % 10 + 1) + " F6000\n";
  return text + "M400\n";
}

}  // namespace

TEST_CASE("A solid that is uploaded and queued is printed, and right") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("bracket.lua")).status == 201);

  const auto created = daemon.post("/api/v1/jobs", kSmall);

  REQUIRE(created.status == 201);
  const auto rest = events.wait_for_rest();
  CHECK(rest["state"] == "idle");
  CHECK(rest["bed_occupied"] == true);
  const auto job = test::json_of(daemon.get(created.headers.at("location")));
  INFO(job.dump());
  CHECK(job["state"] == "done");
  CHECK(job["result"]["violations"] == 0);
  CHECK(job["result"]["sim"]["layers"] == job["result"]["layers"]);
  CHECK(job["result"]["sim"]["components_wrong"] == 0);
  CHECK(job["result"]["sim"]["holes_wrong"] == 0);
}

TEST_CASE("A G-code file is printed line by line; the next waits until the bed is clear") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/moves.gcode", moves(60)).status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "moves.gcode"})").status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "moves.gcode"})").status == 201);
  static_cast<void>(events.wait_for_rest());

  const auto first = test::json_of(daemon.get("/api/v1/jobs/1"));
  const auto second = test::json_of(daemon.get("/api/v1/jobs/2"));

  CHECK(first["state"] == "done");
  CHECK(first["result"]["lines"] == 64);
  CHECK(second["state"] == "queued");
  REQUIRE(daemon.post("/api/v1/printer/bed-cleared").status == 204);
  static_cast<void>(events.wait_for_rest());
  CHECK(test::json_of(daemon.get("/api/v1/jobs/2"))["state"] == "done");
}

TEST_CASE("A print is paused, resumed and cancelled over HTTP") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("bracket.lua")).status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", kTall).status == 201);
  const auto in_state = [](const char* state) {
    return [state](const json& status) { return status["state"] == state; };
  };
  static_cast<void>(events.wait("state", in_state("printing")));
  CHECK(daemon.post("/api/v1/printer/bed-cleared").status == 409);

  REQUIRE(daemon.post("/api/v1/printer/pause").status == 204);
  const auto paused = events.wait("state", in_state("paused"));
  CHECK(paused["job"]["id"] == 1);
  REQUIRE(daemon.post("/api/v1/printer/resume").status == 204);
  static_cast<void>(events.wait("state", in_state("printing")));
  REQUIRE(daemon.post("/api/v1/jobs/1/cancel").status == 204);

  const auto rest = events.wait_for_rest();
  CHECK(rest["state"] == "idle");
  const auto job = test::json_of(daemon.get("/api/v1/jobs/1"));
  CHECK(job["state"] == "cancelled");
  CHECK_THAT(job["message"].get<std::string>(), Contains("heaters are off"));
  CHECK(daemon.post("/api/v1/jobs/1/cancel").status == 409);
  CHECK(daemon.post("/api/v1/printer/pause").status == 409);
}

TEST_CASE("An emergency stop over HTTP ends the print, and somebody must look at the printer") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("bracket.lua")).status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", kTall).status == 201);
  static_cast<void>(events.wait("progress", [](const json& s) { return s["job"]["lines"] > 0; }));

  REQUIRE(daemon.post("/api/v1/printer/emergency-stop").status == 204);

  const auto rest = events.wait_for_rest();
  CHECK(rest["state"] == "stopped");
  CHECK_THAT(rest["message"].get<std::string>(), Contains("emergency stop"));
}

TEST_CASE("A daemon that is stopped ends its print, says so, and does not begin it again") {
  test::RunningDaemon daemon;
  {
    test::EventReader events(daemon);
    REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("bracket.lua")).status == 201);
    REQUIRE(daemon.post("/api/v1/jobs", kTall).status == 201);
    REQUIRE(daemon.post("/api/v1/jobs", kSmall).status == 201);
    static_cast<void>(events.wait("state", [](const json& s) { return !s["job"].is_null(); }));
  }

  daemon.restart();

  CHECK(test::json_of(daemon.get("/api/v1/jobs/1"))["state"] == "interrupted");
  CHECK(test::json_of(daemon.get("/api/v1/jobs/2"))["state"] == "queued");
}

TEST_CASE("A model that does not fit fails its job with the reason") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("bracket.lua")).status == 201);
  REQUIRE(daemon
              .post("/api/v1/jobs",
                    R"({"file": "part.lua", "spec": {"placement": {"fit": [900, 900, 900]}}})")
              .status == 201);

  const auto rest = events.wait_for_rest();

  CHECK(rest["state"] == "stopped");
  CHECK_THAT(rest["message"].get<std::string>(), Contains("part.lua"));
  CHECK(test::json_of(daemon.get("/api/v1/jobs/1"))["state"] == "failed");
}
