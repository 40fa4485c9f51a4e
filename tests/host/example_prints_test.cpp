// The example solids, sliced, printed on the simulated machine and judged: what lies there has the
// topology of the solid.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;

namespace {

/// Known from how they are made: what slicing finer than here gives, too.
struct Betti {
  int components;
  int tunnels;
  int cavities;
};
const std::map<std::string, Betti> kExamples{{"bracket", {1, 3, 0}},
                                             {"gyroid_sphere", {1, 150, 2}},
                                             {"schwarz_cube", {1, 109, 0}},
                                             {"twisted_vase", {1, 0, 0}}};

std::string path_of(const std::string& name) {
  return SLIPSTICK_SOURCE_DIR "/configs/solids/" + name + ".lua";
}

/// What the judge says of `name`, sliced twice as coarsely as is usual, as tests are built without
/// optimisation.
nlohmann::json print(const std::string& name) {
  const test::TemporaryFolder folder;
  const std::string gcode = (folder.path() / "part.gcode").string();
  const std::vector<std::string> coarse{"--sampling", "0.2", "--layer-height", "0.3"};
  std::vector<std::string> slice{"slice", path_of(name), "-o", gcode, "--certify", "off"};
  slice.insert(slice.end(), coarse.begin(), coarse.end());
  const auto sliced = test::slipstick(slice);
  INFO(sliced.err);
  REQUIRE(sliced.status == 0);
  std::vector<std::string> judge{"sim", "--gcode", gcode, "--against", path_of(name), "--json"};
  judge.insert(judge.end(), coarse.begin(), coarse.end());
  const auto judged = test::slipstick(judge);
  INFO(judged.err << judged.out.substr(0, 2000));
  REQUIRE(judged.status == 0);
  return nlohmann::json::parse(judged.out);
}

void check_print(const std::string& name) {
  const auto report = print(name);
  const Betti& wanted = kExamples.at(name);
  CHECK(report["defects"].empty());
  CHECK(report["deposit"]["area_error"] < 0.01);
  CHECK(report["topology"]["printed"]["components"] == wanted.components);
  CHECK(report["topology"]["printed"]["tunnels"] == wanted.tunnels);
  CHECK(report["topology"]["printed"]["cavities"] == wanted.cavities);
}

}  // namespace

// One test each, so that they run side by side.
TEST_CASE("The bracket that is printed is the bracket") {
  check_print("bracket");
}

TEST_CASE("The ball full of gyroid that is printed is the ball") {
  check_print("gyroid_sphere");
}

TEST_CASE("The lattice that is printed is the lattice") {
  check_print("schwarz_cube");
}

TEST_CASE("The vase that is printed is the vase") {
  check_print("twisted_vase");
}

TEST_CASE("Every example is printed by a test") {
  for (const auto& entry :
       std::filesystem::directory_iterator(path_of("").substr(0, path_of("").rfind('/')))) {
    if (entry.path().extension() != ".lua") continue;
    INFO(entry.path().string());
    CHECK(kExamples.count(entry.path().stem().string()) == 1);
  }
}
