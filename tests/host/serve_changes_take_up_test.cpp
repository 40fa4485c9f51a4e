// A print whose settings were changed over HTTP, cut off by kill -9 and taken up: the printer lays
// what it would have laid if nothing had been.
#include <signal.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "host/layer_lines.h"
#include "host/serve/job_spec.h"
#include "tests/support/daemon_process.h"
#include "tests/support/http_client.h"
#include "tests/support/live_printer.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using namespace std::chrono_literals;
using nlohmann::json;

namespace {

constexpr const char* kTube = "return difference(cylinder(5, 2.5), cylinder(3.5, 9))\n";
// A start that waits for no heat.
const json kSpec{{"settings",
                  {{"sampling", 0.25},
                   {"layer_height", 0.25},
                   {"first_layer_height", 0.25},
                   {"certify", "off"},
                   {"perimeters", 1},
                   {"infill_density", 0},
                   {"seconds_per_layer_min", 0},
                   {"first_layer_speed", 120},
                   {"outer_perimeter_speed", 120},
                   {"perimeter_speed", 120},
                   {"nozzle_celsius", 200},
                   {"first_layer_nozzle_celsius", 200},
                   {"start_gcode", "M302 S0\nG92 X100 Y100 Z0 E0"}}}};
const std::string kChange = R"({"perimeters": 2, "flow": 0.9, "retraction": 0.5})";
constexpr long kLayer = 250;  // µm

template <typename Condition>
void until(Condition condition) {
  for (int i = 0; i < 6000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
  REQUIRE(condition());
}

json job(std::uint16_t port) {
  return json::parse(test::request(port, "GET", "/api/v1/jobs/1").body);
}

// The highest layer that something was laid of.
long layer_of(const test::LivePrinter& printer) {
  const auto beads = printer.beads();
  return beads.empty() ? -1 : beads.back()[4] / kLayer - 1;
}

std::vector<test::Bead> expected(const std::filesystem::path& model, int from_layer) {
  const auto spec = job_spec(kSpec, {});
  REQUIRE(spec);
  const auto prepared = prepare_model(model, "a.lua", *spec, SliceGoal::kToolpaths);
  REQUIRE(prepared);
  SlicingRequest request = prepared->request;
  request.timeline = std::make_shared<SettingsTimeline>(request.settings);
  const auto texts = setting_texts(json::parse(kChange));
  REQUIRE(request.timeline->take_up({{from_layer, *texts}}, 0));
  const auto slicing = SlicingJob::start(prepared->placed, request);
  REQUIRE(slicing);
  LayerLines lines(**slicing, request.settings, [](const SlicedLayer&) {});
  std::vector<test::Bead> beads;
  SimTransport sim(*sim_options({}), test::into(beads));
  REQUIRE(stream_job(sim, sim.clock(), lines, {Pace::kVirtual}));
  sim.run_down(1h);
  return test::without_speed(beads);
}

}  // namespace

TEST_CASE("A print that was changed, cut off and taken up is laid as if nothing had been") {
  const test::TemporaryFolder folder;
  const std::string address = (folder.path() / "printer").string();
  const std::filesystem::path data = folder.path() / "data";
  const test::LivePrinter printer(address);
  int from = 0;
  {
    test::DaemonProcess daemon(data, "pty:" + address);
    const std::uint16_t port = daemon.port();
    REQUIRE(test::request(port, "PUT", "/api/v1/files/a.lua", kTube).status == 201);
    REQUIRE(
        test::request(port, "POST", "/api/v1/jobs", json{{"file", "a.lua"}, {"spec", kSpec}}.dump())
            .status == 201);
    until([&] { return layer_of(printer) >= 0; });

    const auto reply = test::request(port, "POST", "/api/v1/jobs/1/settings", kChange);

    REQUIRE(reply.status == 200);
    from = json::parse(reply.body)["from_layer"];
    REQUIRE(from < 9);
    until([&] { return layer_of(printer) >= from; });
    CHECK(daemon.end(SIGKILL) == 128 + SIGKILL);
  }
  test::DaemonProcess daemon(data, "pty:" + address);
  REQUIRE(job(daemon.port())["state"] == "interrupted");

  REQUIRE(test::request(daemon.port(), "POST", "/api/v1/jobs/1/take-up").status == 204);

  until([&] { return job(daemon.port())["state"] == "done"; });
  const json done = job(daemon.port());
  REQUIRE(done["changes"].size() == 1);
  CHECK(done["changes"][0]["from_layer"] == from);
  std::ofstream(folder.path() / "a.lua") << kTube;
  const auto wanted = expected(folder.path() / "a.lua", from);
  until([&] { return printer.count() >= wanted.size(); });
  CHECK(test::without_speed(printer.beads()) == wanted);
}
