// A print that goes on without one of its objects.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "host/config.h"
#include "host/load_model.h"
#include "host/slicing_job.h"
#include "tests/host/serve_fixture.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

// Two towers beside each other, of 40 layers.
constexpr const char* kTowers = R"(
return union(cylinder(3, 12):move(-12, 0, 6), cylinder(3, 12):move(12, 0, 6))
)";
// The left one leans so far that its top is not over the place where it began.
constexpr const char* kLeaning = R"(
return union(cylinder(2, 30):rotate(0, 35, 0):move(-12, 0, 0), cylinder(2, 60):move(12, 0, 0))
)";
constexpr double kLeft = 88, kRight = 112, kMiddle = 100;

struct Sliced {
  std::vector<std::string> programs;
  std::vector<std::size_t> loops;
};

// What is sliced from layer `first` on, with `told` known beforehand.
class Bench {
 public:
  explicit Bench(const char* solid) {
    std::ofstream(model()) << solid;
    settings_ = *load_settings({.overrides = {"certify=off", "layer_height=0.3", "sampling=0.25",
                                              "first_layer_height=0.3", "bottom_layers=2"}});
  }

  Sliced slice(const std::vector<SettingsChange>& told, int first = 0, int threads = 1) const {
    const auto timeline = std::make_shared<SettingsTimeline>(settings_);
    REQUIRE(timeline->take_up(told, 0));
    timeline->go_on();
    const auto loaded = load_model(model().string(), {});
    REQUIRE(loaded);
    const auto placed = place_on_bed(*loaded->model, {}, {kMiddle, kMiddle});
    REQUIRE(placed);
    SlicingRequest request;
    request.settings = settings_;
    request.threads = threads;
    request.first_layer = first;
    request.timeline = timeline;
    const auto job = SlicingJob::start(*placed, request);
    REQUIRE(job);
    Sliced sliced;
    for (auto layer = (*job)->next(); layer && *layer; layer = (*job)->next()) {
      sliced.programs.push_back((*layer)->program->text);
      sliced.loops.push_back((*layer)->contours.outline.loops().size());
      CHECK((*layer)->violations == 0);
    }
    return sliced;
  }

 private:
  std::filesystem::path model() const { return folder_.path() / "a.lua"; }

  test::TemporaryFolder folder_;
  PrintSettings settings_;
};

SettingsChange cancelled(int from_layer, CancelledObject object) {
  return {from_layer, {{kCancelObject, cancelled_object_text(object)}}};
}

}  // namespace

TEST_CASE("From the layer on that is told, and not before, a cancelled object is not there") {
  const Bench bench(kTowers);
  const Sliced whole = bench.slice({});
  REQUIRE(whole.loops == std::vector<std::size_t>(40, 2));

  const Sliced rest = bench.slice({cancelled(10, {7, kLeft, kMiddle})});

  for (std::size_t layer = 0; layer < 40; ++layer) {
    CAPTURE(layer);
    CHECK(rest.loops[layer] == (layer < 10 ? 2 : 1));
    CHECK((rest.programs[layer] == whole.programs[layer]) == (layer < 10));
  }
}

TEST_CASE("An object that leans is followed to where it goes") {
  const Bench bench(kLeaning);
  const Sliced whole = bench.slice({});

  // Layer 70 is 9 mm below the middle.
  const Sliced rest = bench.slice({cancelled(75, {70, kLeft - 6.3, kMiddle})});

  CHECK(std::ranges::count(whole.loops, std::size_t{2}) > 80);
  CHECK(std::ranges::count(rest.loops, std::size_t{2}) < 25);
  for (std::size_t layer = 75; layer < rest.loops.size(); ++layer) {
    CAPTURE(layer);
    CHECK(rest.loops[layer] == 1);
  }
}

TEST_CASE(
    "What is made without an object is the same with any threads, and after a print is taken up") {
  const Bench bench(kTowers);
  const std::vector<SettingsChange> told{cancelled(5, {3, kLeft, kMiddle}),
                                         cancelled(20, {18, kRight, kMiddle})};
  const Sliced once = bench.slice(told);
  CHECK(once.loops[4] == 2);
  CHECK(once.loops[5] == 1);
  CHECK(once.loops[20] == 0);

  CHECK(bench.slice(told, 0, 4).programs == once.programs);
  for (const int first : {5, 6, 19, 33}) {
    CAPTURE(first);
    const Sliced again = bench.slice(told, first);
    CHECK(std::equal(again.programs.begin(), again.programs.end(), once.programs.begin() + first));
  }
}

TEST_CASE("Texts of cancelled objects are read as what they were written from, and no others") {
  const CancelledObject object{12, 0.1 + 0.2, -40.25};
  CHECK(parse_cancelled_object(cancelled_object_text(object)) == object);

  for (const char* text : {"", "1", "1 2", "1 2 3 4", "-1 2 3", "1.5 2 3", "1 x 3", "1  2 3",
                           "99999999999 1 1", "1 2 3 "}) {
    INFO(text);
    CHECK_FALSE(parse_cancelled_object(text));
  }
}

TEST_CASE("A print goes on without the object that was pointed at, and is judged by what is left") {
  const test::RunningDaemon daemon;
  test::EventReader events(daemon);
  const auto wait_for = [&](const char* state) {
    return events.wait("state", [&](const json& seen) { return seen["state"] == state; });
  };
  const auto cancel = [&](const json& place, const std::string& job = "1") {
    return daemon.post("/api/v1/jobs/" + job + "/cancel-object", place.dump());
  };
  const double bed = 110;  // the middle of generic_marlin's
  REQUIRE(daemon.put("/api/v1/files/part.lua", kTowers).status == 201);
  const json spec{{"settings", {{"sampling", 0.25}, {"layer_height", 0.3}, {"certify", "off"}}}};
  REQUIRE(daemon.post("/api/v1/jobs", json{{"file", "part.lua"}, {"spec", spec}}.dump()).status ==
          201);
  REQUIRE(daemon.put("/api/v1/jobs/1/pauses", R"({"layers": [4, 20]})").status == 200);
  REQUIRE(wait_for("paused")["job"]["layer"] == 4);

  for (const json& bad :
       {json{}, json{{"x", 1}}, json{{"x", "1"}, {"y", 2}}, json{{"x", 1}, {"y", 2}, {"z", 3}}}) {
    CHECK(cancel(bad).status == 400);
  }
  CHECK(cancel({{"x", bed}, {"y", bed}}).status == 409);  // between the two
  CHECK(cancel({{"x", bed}, {"y", bed}}, "9").status == 409);
  const auto done = cancel({{"x", bed - 12}, {"y", bed + 1}});
  REQUIRE(done.status == 200);
  const int from = test::json_of(done)["from_layer"];
  CHECK(from >= 4);
  CHECK(from < 20);
  REQUIRE(daemon.post("/api/v1/printer/resume").status == 204);
  REQUIRE(wait_for("printing")["state"] == "printing");
  REQUIRE(wait_for("paused")["job"]["layer"] == 20);
  const auto last = cancel({{"x", bed + 12}, {"y", bed}});
  CHECK(last.status == 409);
  CHECK_THAT(test::json_of(last)["error"].get<std::string>(), Contains("cancel the print"));
  CHECK(cancel({{"x", bed - 12}, {"y", bed}}).status == 409);  // not there any more
  REQUIRE(daemon.post("/api/v1/printer/resume").status == 204);
  static_cast<void>(events.wait_for_rest());

  const json job = test::json_of(daemon.get("/api/v1/jobs/1"));
  CHECK(job["state"] == "done");
  CHECK(job["result"]["violations"] == 0);
  CHECK(job["result"]["sim"]["components_wrong"] == 0);
  REQUIRE(job["changes"].size() == 1);
  CHECK(job["changes"][0]["from_layer"] == from);
}
