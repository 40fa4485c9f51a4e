#include <catch2/catch.hpp>
#include <regex>

#include "core/formats/lua_script.h"
#include "host/atomic_file.h"
#include "host/paper/alpha_study.h"
#include "host/paper/paper_charts.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

PlacedSolid gyroid_ball() {
  const auto model = load_lua_model("return intersection(sphere(6), gyroid(4, 0.9))", "ball.lua");
  if (!model) FAIL(model.error().message);
  const auto placed = place_on_bed(**model, {}, {50, 50});
  if (!placed) FAIL(placed.error().message);
  return *placed;
}

SlicingRequest few_layers() {
  SlicingRequest request;
  request.goal = SliceGoal::kContours;
  request.threads = 1;
  request.first_layer = 20;
  request.end_layer = 24;
  request.settings.slicing.certify = Certification::kOff;
  request.settings.slicing.place = Placement::kSliding;
  return request;
}

}  // namespace

TEST_CASE("A study slices once for each alpha, and has the paper's simplification do it") {
  const std::vector<int> alphas{1, 2, 5};
  SlicingRequest request = few_layers();

  const auto results = alpha_study(gyroid_ball(), request, alphas);

  if (!results) FAIL(results.error().message);
  REQUIRE(results->size() == 3);
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    CHECK((*results)[i].alpha == alphas[i]);
    CHECK((*results)[i].seconds > 0);
  }
  // While there are enough regions to verify, there are the fewer edges, the larger alpha.
  CHECK((*results)[0].edges > (*results)[1].edges);
  CHECK((*results)[1].edges > (*results)[2].edges);
  CHECK((*results)[0].distortion < (*results)[2].distortion);
}

TEST_CASE("The charts of a study have a mark for each alpha, three times") {
  const test::TemporaryFolder folder;
  const std::vector<AlphaResult> results{
      {2, 1e-4, 90'000, 1.5}, {6, 2e-4, 40'000, 1.6}, {10, 3e-4, 30'000, 1.9}, {40, 4e-4, 5, 8}};
  const auto path = folder.path() / "charts.svg";

  REQUIRE(draw_alpha_study(results, "a model", path));

  const std::string svg = *read_file(path);
  const std::regex mark("<path[^>]*fill:rgb\\(10%,30%,60%\\)");
  CHECK(std::distance(std::sregex_iterator(svg.begin(), svg.end(), mark), {}) == 3 * 4);
  CHECK_THAT(draw_alpha_study(results, "", folder.path() / "a.gif").error().message,
             Contains("charts are .svg or .png"));
  CHECK_THAT(draw_alpha_study({}, "", path).error().message, Contains("nothing to draw"));
  CHECK(folder.count() == 1);
}

TEST_CASE("Charts are of Hand and Spine, and are refused without their models or a folder") {
  std::vector<std::string_view> names;
  for (const PaperRow& row : paper_rows()) {
    if (has_charts(row)) names.push_back(row.name);
  }
  CHECK(names == std::vector<std::string_view>{"Spine", "Hand"});
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();

  const auto none = test::slipstick({"bench", "paper", "--models", path, "--charts", path});
  const auto nowhere = test::slipstick({"bench", "paper", "--charts", path + "/nowhere"});

  CHECK(none.status == 1);
  CHECK_THAT(none.err, Contains("Hand: skipped: there is no hand_bones_myosim.ply") &&
                           Contains("no row was run"));
  CHECK(nowhere.status == 1);
  CHECK_THAT(nowhere.err, Contains("there is no such folder; make it"));
  CHECK(folder.count() == 0);
}
