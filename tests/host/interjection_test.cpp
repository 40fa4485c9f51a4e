// What is said to a printer between two lines of its print.
#include <catch2/catch.hpp>

#include "drivers/marlin/interjection.h"
#include "host/stream_job.h"
#include "sim/sim_transport.h"
#include "tests/host/serve_fixture.h"
#include "tests/support/spiral.h"

using namespace slipstick;
using nlohmann::json;

namespace {

std::vector<Line> heat_to(int celsius) {
  return {*interjection("M104 S" + std::to_string(celsius))};
}

/// A spiral in which the nozzle is to be hotter from a line on, maybe in a pause.
struct Spiral {
  void print(std::uint64_t at, bool paused) {
    PrintControl* handle = nullptr;
    int turns = 0;
    PrintControl control({{}, [&](SenderState, const StreamFigures& figures) {
                            if (turns == 0 && figures.counters.lines_sent == at && paused)
                              handle->pause();
                            if (turns == 0 && figures.counters.lines_sent == at)
                              REQUIRE(handle->interject(heat_to(211)));
                            if (figures.counters.lines_sent >= at && ++turns == 9) handle->resume();
                          }});
    handle = &control;
    test::ProgramLines lines(test::spiral("M83"));
    StreamOptions options{Pace::kVirtual, ParkingPlace{.x = 5,
                                                       .y = 215,
                                                       .height_max = 250,
                                                       .retraction = 1,
                                                       .retraction_speed = 30,
                                                       .travel_speed = 100,
                                                       .lift_speed = 10}};
    const auto outcome = stream_job(sim, sim.clock(), lines, options, control);
    REQUIRE(outcome);
    acknowledged = outcome->counters.lines_acknowledged;
    sim.run_down(std::chrono::hours(1));
  }

  std::vector<test::Bead> beads;
  SimTransport sim{*sim_options({}), test::into(beads)};
  std::uint64_t acknowledged = 0;
};

constexpr std::uint64_t kNever = 1'000'000;

}  // namespace

TEST_CASE("A line said in a print takes effect, and the print is what it would have been") {
  Spiral undisturbed;
  undisturbed.print(kNever, false);
  const bool paused = GENERATE(false, true);
  for (const std::uint64_t at : {5U, 20U, 40U}) {
    INFO("at line " << at << (paused ? ", paused" : ""));
    Spiral spiral;
    spiral.print(at, paused);

    CHECK(spiral.sim.printer().machine().nozzle.target() == 211);
    CHECK(spiral.beads == undisturbed.beads);
    CHECK(spiral.acknowledged == undisturbed.acknowledged);
  }
}

TEST_CASE("No more lines wait to be said than were agreed, and they keep their order") {
  PrintControl control;
  CHECK_FALSE(control.interject(heat_to(0)));  // nobody would send it
  control.begin_listening();
  for (std::size_t i = 0; i < PrintControl::kInterjectionsMax; ++i) {
    CHECK(control.interject(heat_to(static_cast<int>(i))));
  }
  CHECK_FALSE(control.interject(heat_to(99)));
  CHECK_FALSE(control.end_listening());

  for (std::size_t i = 0; i < PrintControl::kInterjectionsMax; ++i) {
    CHECK(control.take_interjection() == heat_to(static_cast<int>(i)).front());
  }
  CHECK(control.take_interjection() == std::nullopt);
  CHECK(control.end_listening());
  CHECK_FALSE(control.interject(heat_to(0)));
}

TEST_CASE("What is changed in a print over HTTP reaches the printer, by OctoPrint's words too") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  CHECK(daemon.post("/api/v1/printer/adjust", R"({"nozzle": 201})").status == 409);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("gyroid_sphere.lua")).status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "part.lua"})").status == 201);
  // The second layer begins with the program's own temperature.
  const auto started = [](const json& s) { return s["job"]["layer"] > 2; };
  REQUIRE(!events.wait("progress", started).is_null());
  const auto becomes = [&](const char* heater, int target) {
    return !events
                .wait("temperatures",
                      [&](const json& seen) { return seen[heater]["target"] == target; })
                .is_null();
  };

  REQUIRE(daemon.post("/api/v1/printer/adjust", R"({"nozzle": 201, "feed": 90})").status == 204);
  CHECK(becomes("nozzle", 201));
  REQUIRE(daemon.post("/api/v1/printer/commands", R"({"commands": ["M104 S202"]})").status == 204);
  CHECK(becomes("nozzle", 202));
  REQUIRE(daemon.post("/api/printer/tool", R"({"command": "target", "targets": {"tool0": 203}})")
              .status == 204);
  CHECK(becomes("nozzle", 203));
  REQUIRE(daemon.post("/api/printer/bed", R"({"command": "target", "target": 61})").status == 204);
  CHECK(becomes("bed", 61));
  REQUIRE(daemon.post("/api/printer/command", R"({"command": "M104 S204"})").status == 204);
  CHECK(becomes("nozzle", 204));
  for (const char* factor : {"105", "1.05"}) {
    const std::string body = R"({"command": "feedrate", "factor": )" + std::string(factor) + "}";
    CHECK(daemon.post("/api/printer/printhead", body).status == 204);
  }
  CHECK(daemon.post("/api/printer/tool", R"({"command": "flowrate", "factor": 98})").status == 204);

  for (const char* body : {"", "[]", "{}", R"({"heat": 1})", R"({"nozzle": "hot"})",
                           R"({"nozzle": 301})", R"({"z": 1})"}) {
    CAPTURE(body);
    CHECK(daemon.post("/api/v1/printer/adjust", body).status == 400);
  }
  for (const char* body :
       {"", R"({"commands": 5})", R"({"commands": ["G1 X5"]})", R"({"commands": ["M112"]})"}) {
    CAPTURE(body);
    CHECK(daemon.post("/api/v1/printer/commands", body).status == 400);
  }
  CHECK(daemon.post("/api/printer/printhead", R"({"command": "home", "axes": ["z"]})").status ==
        409);
  CHECK(daemon.post("/api/v1/jobs/1/cancel").status == 204);
  static_cast<void>(events.wait_for_rest());
}
