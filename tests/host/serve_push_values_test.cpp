// OctoPrint's push socket without sockets: what is said.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "host/serve/octoprint_push.h"
#include "host/serve/status_reporter.h"

using namespace slipstick;
using nlohmann::json;

namespace {

using Wish = PrintControl::Wish;
using Names = std::vector<std::string>;

OctoMoment moment() {
  OctoMoment moment;
  moment.status.activity = PrinterActivity::kPrinting;
  moment.status.job = 3;
  moment.status.file = moment.name = "a.gcode";
  moment.status.height = 1.2;
  moment.status.completion = 0.5;
  moment.status.seconds = 100;
  moment.status.seconds_left = 100;
  moment.status.lines_sent = 200;
  moment.status.resends = 4;
  Temperatures seen;
  seen.hotend = HeaterReading{201.5, 205};
  moment.status.temperatures = seen;
  moment.file = StoredFile{1, "a.gcode", ".gcode", 77, 1'700'000'000};
  moment.time = 1'800'000'000;
  return moment;
}

/// What the daemon tells, and what comes of it in OctoPrint's words.
class Told {
 public:
  StatusReporter& reporter() { return reporter_; }
  void publish(const std::string& type, const json& data) { log_.publish(type, data.dump()); }

  /// The events since the last call.
  std::vector<PushEvent> events() {
    std::vector<PushEvent> all;
    for (const auto& event : log_.since(seen_).events) {
      for (auto& said : push_.heard(event)) all.push_back(said);
    }
    seen_ = log_.last();
    return all;
  }
  Names names() {
    Names names;
    for (const PushEvent& event : events()) names.push_back(event.name);
    return names;
  }

 private:
  StatusBoard board_;
  EventLog log_{[] {}};
  StatusReporter reporter_{board_, log_};
  PushEvents push_;
  std::int64_t seen_ = 0;
};

}  // namespace

TEST_CASE("The state is told as OctoPrint's clients expect it") {
  const json message = json::parse(push_state("current", moment(), {"Recv: ok"}));

  const json state = message["current"];
  CHECK(state["state"]["text"] == "Printing");
  CHECK(state["state"]["flags"]["printing"] == true);
  CHECK(state["job"]["file"] == json{{"name", "a.gcode"},
                                     {"display", "a.gcode"},
                                     {"path", "a.gcode"},
                                     {"origin", "local"},
                                     {"size", 77},
                                     {"date", 1'700'000'000}});
  CHECK(state["progress"]["completion"] == 50);
  CHECK(state["progress"]["printTimeLeft"] == 100);
  CHECK(state["currentZ"] == 1.2);
  CHECK(state["temps"][0]["time"] == 1'800'000'000);
  CHECK(state["temps"][0]["tool0"]["actual"] == 201.5);
  CHECK(state["temps"][0]["tool0"]["target"] == 205);
  CHECK(state["resends"] == json{{"count", 4}, {"transmitted", 200}, {"ratio", 2}});
  CHECK(state["logs"] == json{"Recv: ok"});
  CHECK(state["messages"] == json::array());
  CHECK(state["busyFiles"] == json::array({{{"origin", "local"}, {"path", "a.gcode"}}}));
  CHECK(state["serverTime"] == 1'800'000'000);
}

TEST_CASE("Whoever connects is told what this is") {
  const json connected = json::parse(push_connected())["connected"];

  CHECK(connected["version"] == "1.10.0");
  for (const char* key : {"display_version", "branch", "plugin_hash", "config_hash"}) {
    CHECK(connected[key].is_string());
  }
}

TEST_CASE("What the printer says cannot break out of a message") {
  const std::string text = "echo:\"</script>\n\xff\\";

  const json raw = json::parse(push_state("current", moment(), {text}));
  const std::string frame = sock_js_frame(push_state("current", moment(), {text}));

  CHECK(raw["current"]["logs"][0].get<std::string>().starts_with("echo:\"</script>\n"));
  CHECK(json::parse(json::parse(frame.substr(1))[0].get<std::string>()) == raw);
}

TEST_CASE("A print is told from its beginning to its end") {
  Told told;
  told.reporter().bed(false);
  static_cast<void>(told.names());

  told.reporter().job_began(7, "a.gcode");
  CHECK(told.names() == Names{"Connected", "PrinterStateChanged", "PrintStarted"});
  PrintedLayer layer;
  layer.layer = 1;
  layer.height = 0.2;
  told.reporter().layer_began(layer);
  told.reporter().turn(Wish::kPause, {});
  CHECK(told.names() == Names{"PrinterStateChanged", "PrintPaused", "ZChange"});
  told.reporter().turn(Wish::kRun, {});
  CHECK(told.names() == Names{"PrinterStateChanged", "PrintResumed"});
  told.reporter().job_came_to(7, "done", "");
  told.reporter().job_ended(PrinterActivity::kIdle, "");
  told.reporter().bed(true);

  const auto end = told.events();
  REQUIRE(end.size() == 2);
  CHECK(end[0].name == "PrintDone");
  CHECK(json::parse(end[0].text)["event"]["payload"]["name"] == "a.gcode");
  CHECK(json::parse(end[0].text)["event"]["payload"]["time"].is_number());
  CHECK(end[1].name == "PrinterStateChanged");
}

TEST_CASE("A cancelled print, a failed one and an emergency stop are told apart") {
  Told told;
  told.reporter().job_began(7, "a.gcode");
  static_cast<void>(told.names());

  SECTION("cancelled") {
    told.reporter().turn(Wish::kCancel, {});
    told.reporter().job_came_to(7, "cancelled", "");
    told.reporter().job_ended(PrinterActivity::kIdle, "cancelled at line 3");
    told.reporter().bed(true);

    const auto events = told.events();
    REQUIRE(events.size() == 5);
    CHECK(events[1].name == "PrintCancelling");
    CHECK(events[2].name == "PrintCancelled");
    CHECK(events[3].name == "PrintFailed");
    CHECK(json::parse(events[3].text)["event"]["payload"]["reason"] == "cancelled");
    CHECK(events[4].name == "PrinterStateChanged");
  }
  SECTION("failed") {
    told.reporter().job_came_to(7, "failed", "");
    told.reporter().job_ended(PrinterActivity::kStopped, "it fell silent");

    const auto events = told.events();
    REQUIRE(events.size() == 4);
    CHECK(events[0].name == "PrintFailed");
    CHECK(json::parse(events[0].text)["event"]["payload"]["reason"] == "error");
    CHECK(events[1].name == "Error");
    CHECK(json::parse(events[1].text)["event"]["payload"]["error"] == "it fell silent");
    CHECK(events[2].name == "Disconnected");
    CHECK(events[3].name == "PrinterStateChanged");
  }
  SECTION("stopped") {
    told.publish("emergency", json::object());
    CHECK(told.names() == Names{"EStop"});
  }
  SECTION("another job is cancelled, which waited") {
    told.publish("jobs", {{"id", 8}, {"state", "cancelled"}});
    CHECK(told.names().empty());
  }
}

TEST_CASE("A connection that is lost between prints is told, the end of a print is none") {
  Told told;
  told.reporter().connected(true, "");
  CHECK(told.names() == Names{"Connected", "PrinterStateChanged"});

  told.reporter().connected(false, "cannot open /dev/ttyUSB0");
  CHECK(told.names() == Names{"Disconnected"});
  told.reporter().connected(true, "");
  CHECK(told.names() == Names{"Connected"});
}

TEST_CASE("Files that come and go are told") {
  Told told;
  told.publish("files", {{"name", "a.lua"}, {"size", 3}});
  told.publish("files", {{"removed", "a.lua"}});

  const auto events = told.events();

  REQUIRE(events.size() == 4);
  CHECK(events[0].name == "FileAdded");
  CHECK(
      json::parse(events[0].text)["event"]["payload"] ==
      json{{"storage", "local"}, {"path", "a.lua"}, {"name", "a.lua"}, {"type", {"model", "stl"}}});
  CHECK(events[1].name == "UpdatedFiles");
  CHECK(events[2].name == "FileRemoved");
  CHECK(events[3].name == "UpdatedFiles");
}
