// Settings changed over HTTP while a model is printed.
#include <catch2/catch.hpp>
#include <functional>

#include "tests/host/serve_fixture.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

constexpr const char* kTube = "return difference(cylinder(6, 30), cylinder(3, 90))\n";
constexpr const char* kSpec = R"({"file": "part.lua", "spec": {"settings": {"sampling": 0.3,
    "layer_height": 0.3, "first_layer_height": 0.3, "certify": "off", "infill_density": 0.1}}})";

// Prints the tube, paused at its beginning.
class PausedPrint {
 public:
  PausedPrint() {
    REQUIRE(daemon.put("/api/v1/files/part.lua", kTube).status == 201);
    REQUIRE(daemon.post("/api/v1/jobs", kSpec).status == 201);
    static_cast<void>(events.wait("state", is("printing")));
    REQUIRE(daemon.post("/api/v1/printer/pause").status == 204);
    static_cast<void>(events.wait("state", is("paused")));
  }

  test::HttpReply change(const std::string& body) const {
    return daemon.post("/api/v1/jobs/1/settings", body);
  }
  json job() const { return test::json_of(daemon.get("/api/v1/jobs/1")); }
  json finished() {
    REQUIRE(daemon.post("/api/v1/printer/resume").status == 204);
    static_cast<void>(events.wait("state", [](const json& s) { return s["job"].is_null(); }));
    return job();
  }

  test::RunningDaemon daemon;
  test::EventReader events{daemon};

 private:
  static std::function<bool(const json&)> is(const char* state) {
    return [state](const json& status) { return status["state"] == state; };
  }
};

std::string message(const test::HttpReply& reply) {
  return test::json_of(reply)["error"].get<std::string>();
}

}  // namespace

TEST_CASE("Settings are changed in a pause, hold from the next layer on, and the report tells it") {
  PausedPrint plain;
  const json without = plain.finished();
  CHECK(without["changes"] == json::array());
  PausedPrint print;

  const auto first = print.change(R"({"infill_density": 0.9, "nozzle_celsius": "215"})");
  const auto second = print.change(R"({"perimeters": 3})");

  REQUIRE(first.status == 200);
  REQUIRE(second.status == 200);
  const int from = test::json_of(first)["from_layer"];
  CHECK(from < 90);
  const json told{
      {{"from_layer", from}, {"settings", {{"infill_density", 0.9}, {"nozzle_celsius", 215}}}},
      {{"from_layer", test::json_of(second)["from_layer"]}, {"settings", {{"perimeters", 3}}}}};
  CHECK(print.job()["changes"] == told);
  const json done = print.finished();
  CHECK(done["state"] == "done");
  CHECK(done["changes"] == told);
  CHECK(done["spec"]["settings"]["infill_density"] == 0.1);
  CHECK(done["result"]["sim"]["components_wrong"] == 0);
  CHECK(done["result"]["filament_mm"] > without["result"]["filament_mm"]);
}

TEST_CASE("What cannot be changed in a print is refused, and nothing is changed") {
  const PausedPrint print;

  for (const char* body :
       {"", "[]", "{}", "7", R"({"infill_density": [1]})", R"({"infill_density": null})",
        R"({"infill_density": 7})", R"({"infill": 0.5})", R"({"infill_density": "dense"})"}) {
    INFO(body);
    CHECK(print.change(body).status == 400);
  }
  const auto settled = print.change(R"({"perimeters": 3, "layer_height": 0.1})");

  CHECK(settled.status == 400);
  CHECK_THAT(message(settled), Contains("layer_height: cannot change in a print"));
  CHECK(print.job()["changes"] == json::array());
}

TEST_CASE("Only a model that is queued or being printed can be changed") {
  PausedPrint print;
  REQUIRE(print.finished()["state"] == "done");
  REQUIRE(print.daemon.put("/api/v1/files/a.gcode", "G28\n").status == 201);
  REQUIRE(print.daemon.post("/api/v1/jobs", R"({"file": "a.gcode"})").status == 201);
  const std::string body = R"({"perimeters": 3})";

  const auto over = print.change(body);
  const auto gcode = print.daemon.post("/api/v1/jobs/2/settings", body);

  CHECK(over.status == 409);
  CHECK_THAT(message(over), Contains("over"));
  CHECK(gcode.status == 409);
  CHECK_THAT(message(gcode), Contains("G-code"));
  CHECK(print.daemon.post("/api/v1/jobs/9/settings", body).status == 404);
  CHECK(print.daemon.post("/api/v1/jobs/x/settings", body).status == 404);
  CHECK(print.job()["changes"] == json::array());
}

TEST_CASE("Of a job that waits, any setting is changed, and it is printed like that") {
  PausedPrint print;
  REQUIRE(print.daemon.post("/api/v1/jobs", kSpec).status == 201);
  const auto change = [&](const char* body) {
    return print.daemon.post("/api/v1/jobs/2/settings", body);
  };

  const auto done = change(R"({"layer_height": 0.25, "first_layer_height": 0.25})");
  const auto bad = change(R"({"layer_height": 9})");

  REQUIRE(done.status == 200);
  CHECK(test::json_of(done)["from_layer"] == 0);
  CHECK(bad.status == 400);
  static_cast<void>(print.finished());
  REQUIRE(print.daemon.post("/api/v1/printer/bed-cleared").status == 204);
  static_cast<void>(print.events.wait_for_rest());
  const json job = test::json_of(print.daemon.get("/api/v1/jobs/2"));
  CHECK(job["state"] == "done");
  CHECK(job["spec"]["settings"]["layer_height"] == 0.25);
  CHECK(job["spec"]["settings"]["infill_density"] == 0.1);
  CHECK(job["changes"] == json::array());
  CHECK(job["result"]["layers"] == 120);
}
