// /metrics: the text format of Prometheus, line by line, and the same values as the API's.
#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>

#include "tests/host/serve_fixture.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

using Samples = std::map<std::string, double>;  // "name{label=\"value\"}" to value

const std::regex kDescription("# (HELP|TYPE) ([a-zA-Z_:][a-zA-Z0-9_:]*) (.+)");
const std::regex kSample(
    R"re(([a-zA-Z_:][a-zA-Z0-9_:]*)(\{[a-z_]+="[^"\\]*"(,[a-z_]+="[^"\\]*")*\})? (\S+))re");

// Every line must be one of the format, and every sample behind the type of its family, which
// comes once.
Samples samples_of(const std::string& text) {
  Samples samples;
  std::set<std::string> families;
  std::string family;
  REQUIRE(text.ends_with('\n'));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    std::smatch part;
    if (std::regex_match(line, part, kDescription)) {
      if (part[1] == "TYPE") {
        CHECK((part[3] == "gauge" || part[3] == "counter"));
        CHECK((part[3] == "counter") == part[2].str().ends_with("_total"));
        family = part[2];
        CHECK(families.insert(family).second);
      }
      continue;
    }
    REQUIRE(std::regex_match(line, part, kSample));
    CHECK(part[1] == family);
    std::size_t used = 0;
    const double value = std::stod(part[4].str(), &used);
    CHECK(used == part[4].str().size());
    CHECK(samples.emplace(part[1].str() + part[2].str(), value).second);
  }
  return samples;
}

Samples metrics(const test::RunningDaemon& daemon) {
  const auto reply = daemon.get("/metrics");
  REQUIRE(reply.status == 200);
  CHECK_THAT(reply.headers.at("content-type"), Contains("text/plain; version=0.0.4"));
  return samples_of(reply.body);
}

void check_state(const Samples& samples, const std::string& state) {
  double sum = 0;
  for (const auto& [name, value] : samples) {
    if (name.starts_with("slipstick_printer_state{")) sum += value;
  }
  CHECK(sum == 1);
  CHECK(samples.at("slipstick_printer_state{state=\"" + state + "\"}") == 1);
}

}  // namespace

TEST_CASE("An idle daemon's metrics say so, and what the process takes") {
  const test::RunningDaemon daemon;

  const Samples idle = metrics(daemon);

  check_state(idle, "idle");
  CHECK(idle.at("slipstick_printer_connected") == 0);
  CHECK(idle.at("slipstick_bed_occupied") == 0);
  CHECK(idle.at("slipstick_queued_jobs") == 0);
  CHECK(idle.at("slipstick_uptime_seconds") > 0);
  CHECK(idle.at("process_resident_memory_bytes") > 1e6);
  CHECK(!idle.contains("slipstick_job_layers"));
  CHECK(idle.at("slipstick_info{version=\"" SLIPSTICK_VERSION "\"}") == 1);
}

TEST_CASE("In a print the metrics are those of the API") {
  const test::RunningDaemon daemon("sim:?realtime=1");
  test::EventReader events(daemon);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("bracket.lua")).status == 201);
  for (int i = 0; i < 3; ++i) {
    REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "part.lua"})").status == 201);
  }
  const auto heats = events.wait("temperatures", [](const json& seen) {
    return seen.contains("nozzle") && seen["nozzle"]["target"].is_number() &&
           seen["nozzle"]["target"] > 0;
  });
  REQUIRE(!heats.is_null());

  const json before = test::json_of(daemon.get("/api/v1/printer"));
  const Samples now = metrics(daemon);
  const json after = test::json_of(daemon.get("/api/v1/printer"));

  check_state(now, "printing");
  CHECK(now.at("slipstick_printer_connected") == 1);
  CHECK(now.at("slipstick_bed_occupied") == 1);
  CHECK(now.at("slipstick_queued_jobs") == 2);
  CHECK(now.at("slipstick_job_layers") == before["job"]["layers"]);
  const auto between = [&](const char* metric, const char* member) {
    INFO(metric);
    CHECK(now.at(metric) >= before["job"][member]);
    CHECK(now.at(metric) <= after["job"][member]);
  };
  between("slipstick_job_lines_acknowledged_total", "lines");
  between("slipstick_job_resends_total", "resends");
  between("slipstick_job_starved_seconds_total", "starved_seconds");
  between("slipstick_job_completion_ratio", "completion");
  between("slipstick_job_layer", "layer");
  between("slipstick_job_seconds", "seconds");
  for (const char* heater : {"nozzle", "bed"}) {
    const std::string label = std::string("{heater=\"") + heater + "\"}";
    const json& was = before["temperatures"][heater]["actual"];
    const json& is = after["temperatures"][heater]["actual"];
    const double actual = now.at("slipstick_temperature_celsius" + label);
    CHECK(actual >= std::min(was.get<double>(), is.get<double>()));
    CHECK(actual <= std::max(was.get<double>(), is.get<double>()));
    CHECK(now.at("slipstick_target_celsius" + label) == before["temperatures"][heater]["target"]);
  }
}

TEST_CASE("Metrics are for whoever shows the key") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey);

  CHECK(daemon.get("/metrics").status == 401);
  CHECK(test::request(daemon.port(), "GET", "/metrics", "",
                      "Authorization: Bearer " + daemon.key() + "\r\n")
            .status == 200);
}
