// What `slipstick info` tells of a model, and where it says a sampling is too coarse.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

test::Finished info(const std::string& script, std::vector<std::string> more) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "model.lua";
  std::ofstream(path) << "return " << script << '\n';
  std::vector<std::string> words{"info", path.string()};
  words.insert(words.end(), more.begin(), more.end());
  return test::slipstick(words);
}

nlohmann::json info_json(const std::string& script, std::vector<std::string> more = {}) {
  more.emplace_back("--json");
  const auto finished = info(script, more);
  INFO(finished.err);
  REQUIRE(finished.status == 0);
  return nlohmann::json::parse(finished.out);
}

// Walls of 3 mm and more, a slot of 0.8 mm at x = 2.
constexpr const char* kSlotted = "difference(box(12, 10, 8), box(0.8, 4, 2):move(2, 0, 0))";

}  // namespace

TEST_CASE("The thinnest places of a model are told with where they are") {
  const auto json = info_json(kSlotted);

  CHECK(json.at("smallest_gap").at("mm").get<double>() == Approx(0.8).epsilon(0.01));
  const auto at = json.at("smallest_gap").at("at").get<std::array<double, 3>>();
  CHECK(at[0] == Approx(2).margin(0.01));
  CHECK(std::abs(at[1]) <= 2);
  CHECK(std::abs(at[2] - 4) <= 1);
  CHECK(json.at("smallest_feature").at("mm").get<double>() == Approx(3).epsilon(0.01));
  CHECK(json.at("estimated_from").at("sections") == 96);
  CHECK(json.at("estimated_from").at("step").get<double>() == Approx(0.012).epsilon(0.01));
  CHECK(info_json("sphere(5)").at("smallest_gap").is_null());
  CHECK(info_json("cone(5, 0, 10)").at("smallest_feature").is_null());
}

TEST_CASE("A sampling that is too coarse for a gap or a feature is told with where") {
  const double limit = 0.4 / std::sqrt(3.0);  // r / sqrt(3), r half of the gap

  const auto json = info_json(kSlotted, {"--sampling", "0.25"}).at("sampling_too_coarse");

  CHECK(json.at("because_of") == "gap");
  CHECK(json.at("mm").get<double>() == Approx(0.8).epsilon(0.01));
  CHECK(json.at("below").get<double>() == Approx(limit).epsilon(0.01));
  CHECK(json.at("sampling") == 0.25);
  CHECK(json.at("at")[0].get<double>() == Approx(2).margin(0.01));
  CHECK(info_json(kSlotted, {"--sampling", "0.2"}).at("sampling_too_coarse").is_null());
  CHECK(info_json(kSlotted).at("sampling_too_coarse").is_null());
  CHECK(info_json("box(10, 10, 0.5)", {"--sampling", "0.2"})
            .at("sampling_too_coarse")
            .at("because_of") == "feature");
  CHECK_THAT(
      info(kSlotted, {"--sampling", "0.25"}).out,
      Contains("smallest gap: 0.8 mm at (2.00, ") &&
          Contains("sampling 0.25 mm is too coarse: it must be below 0.231 mm for the gap of"));
}

TEST_CASE("The sampling recommended is fine enough for what was found") {
  CHECK(info_json("box(10, 10, 10)").at("recommended_sampling") == 0.1);
  CHECK(info_json("box(500, 10, 10)").at("recommended_sampling") == 0.2);
  // 0.1 mm thick: r / sqrt(3) is 0.0289.
  CHECK(info_json("box(10, 10, 0.1)").at("recommended_sampling") == 0.028);
  // No lattice is finer than that of 16,384 nodes a side, and 0.01 mm.
  CHECK(info_json("box(10, 10, 0.02)").at("recommended_sampling") == 0.01);
  CHECK_THAT(info("box(10, 10, 0.02)", {}).out,
             Contains("sampling 0.01 mm is too coarse: it must be below 0.0057"));
}

TEST_CASE("An empty solid has no thickness, and a sampling has a range") {
  const auto empty = info("(x * x + 1):bounds(-1, -1, -1, 1, 1, 1)", {});

  CHECK(empty.status == 1);
  CHECK_THAT(empty.err, Contains("the solid is empty"));
  CHECK(info("sphere(5)", {"--sampling", "0"}).status == 2);
  CHECK(info("sphere(5)", {"--sampling", "3"}).status == 2);
}
