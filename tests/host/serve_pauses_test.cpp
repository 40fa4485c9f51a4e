// Layers before which a print waits for somebody.
#include <catch2/catch.hpp>

#include "tests/host/serve_fixture.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

constexpr const char* kTube = "return difference(cylinder(6, 3), cylinder(3, 90))\n";
constexpr const char* kJob = R"({"file": "part.lua", "spec": {"settings": {"sampling": 0.3,
    "layer_height": 0.3, "first_layer_height": 0.3, "certify": "off"}}})";

// The tube of ten layers, held at once so that pauses can be asked for; job 1.
struct HeldPrint {
  HeldPrint() {
    REQUIRE(daemon.put("/api/v1/files/part.lua", kTube).status == 201);
    REQUIRE(daemon.post("/api/v1/jobs", kJob).status == 201);
    static_cast<void>(wait_for("printing"));
    REQUIRE(daemon.post("/api/v1/printer/pause").status == 204);
    static_cast<void>(wait_for("paused"));
  }

  test::HttpReply put(const std::string& body, const std::string& job = "1") const {
    return daemon.put("/api/v1/jobs/" + job + "/pauses", body);
  }
  json pauses() const { return test::json_of(daemon.get("/api/v1/jobs/1"))["pauses"]; }
  json wait_for(const std::string& state) {
    return events.wait("state", [&](const json& seen) { return seen["state"] == state; });
  }
  /// Goes on. \return the layers begun by the next pause.
  int next_pause() {
    REQUIRE(daemon.post("/api/v1/printer/resume").status == 204);
    static_cast<void>(wait_for("printing"));
    return wait_for("paused")["job"]["layer"];
  }
  json finished() {
    REQUIRE(daemon.post("/api/v1/printer/resume").status == 204);
    static_cast<void>(events.wait_for_rest());
    return test::json_of(daemon.get("/api/v1/jobs/1"));
  }

  test::RunningDaemon daemon;
  test::EventReader events{daemon};
};

}  // namespace

TEST_CASE("A print pauses before each layer it was told to, and lays the same") {
  HeldPrint print;

  CHECK(test::json_of(print.put(R"({"layers": [7, 4, 7]})"))["layers"] == json({4, 7}));

  CHECK(print.next_pause() == 4);
  CHECK(print.next_pause() == 7);
  const json job = print.finished();
  CHECK(job["state"] == "done");
  CHECK(job["result"]["layers"] == 10);
  CHECK(job["result"]["sim"]["components_wrong"] == 0);
}

TEST_CASE("A pause that is taken back in time does not happen, and one that is added does") {
  HeldPrint print;
  REQUIRE(print.put(R"({"layers": [4, 7]})").status == 200);
  REQUIRE(print.next_pause() == 4);

  REQUIRE(print.put(R"({"layers": [8]})").status == 200);

  CHECK(print.next_pause() == 8);
  CHECK(print.finished()["state"] == "done");
}

TEST_CASE("Pauses that cannot be are refused, and nothing is changed") {
  HeldPrint print;
  REQUIRE(print.put(R"({"layers": [9]})").status == 200);

  std::string many = "0";
  for (int i = 1; i <= 100; ++i) many += "," + std::to_string(i);
  for (const std::string& body :
       {std::string(), std::string("[]"), std::string(R"({"layers": 3})"),
        std::string(R"({"layers": [-1]})"), std::string(R"({"layers": [1.5]})"),
        std::string(R"({"layers": ["1"]})"), std::string(R"({"layers": [99999999999]})"),
        std::string(R"({"layers": [1], "more": 1})"), R"({"layers": [)" + many + "]}"}) {
    INFO(body);
    CHECK(print.put(body).status == 400);
  }
  CHECK(print.put(R"({"layers": [1]})", "9").status == 404);
  CHECK(print.put(R"({"layers": [1]})", "x").status == 404);

  CHECK(print.pauses() == json({9}));
}

TEST_CASE(
    "A job that waits keeps its pauses across a restart; one that is over, or G-code, has none") {
  test::RunningDaemon daemon;
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/a.gcode", "G28\n").status == 201);
  REQUIRE(daemon.put("/api/v1/files/part.lua", kTube).status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "a.gcode"})").status == 201);
  static_cast<void>(events.wait_for_rest());
  REQUIRE(daemon.post("/api/v1/jobs", kJob).status == 201);
  const auto gcode = daemon.put("/api/v1/jobs/1/pauses", R"({"layers": [1]})");
  REQUIRE(daemon.put("/api/v1/jobs/2/pauses", R"({"layers": [3]})").status == 200);

  daemon.restart();

  CHECK(test::json_of(daemon.get("/api/v1/jobs/2"))["pauses"] == json({3}));
  CHECK(gcode.status == 409);
  CHECK_THAT(test::json_of(gcode)["error"].get<std::string>(), Contains("G-code"));
  REQUIRE(daemon.post("/api/v1/jobs/2/cancel").status == 204);
  CHECK(daemon.put("/api/v1/jobs/2/pauses", R"({"layers": [1]})").status == 409);
}
