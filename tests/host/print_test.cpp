// Whole prints on the embedded simulator: the thing printed has the topology of the contours.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;

namespace {

nlohmann::json print(std::vector<std::string> words) {
  words.insert(words.begin(), "print");
  words.insert(words.end(), {"--json"});
  const auto done = test::slipstick(words);
  INFO(done.err);
  REQUIRE(done.status == 0);
  return nlohmann::json::parse(done.out);
}

void check_right(const nlohmann::json& report) {
  CHECK(report["verified"]["violations"] == 0);
  CHECK(report["sim"]["deposit"]["layers"] == report["layers"]);
  CHECK(report["sim"]["deposit"]["components_wrong"] == 0);
  CHECK(report["sim"]["deposit"]["holes_wrong"] == 0);
  CHECK(report["printer"]["lines_sent"] == report["printer"]["lines_acknowledged"]);
}

std::string solid(const std::string& name) {
  return std::string(SLIPSTICK_SOURCE_DIR) + "/configs/solids/" + name;
}

}  // namespace

TEST_CASE("A lattice prints right over a noisy cable, and the noise was there") {
  const auto report = print({solid("schwarz_cube.lua"), "--scale", "0.4", "--port",
                             "sim:?seed=7&corrupt=0.0001", "--layer-height", "0.3"});

  check_right(report);
  CHECK(report["sim"]["bytes_damaged"] > 0);
  CHECK(report["printer"]["resends"] > 0);
}

TEST_CASE("A part prints right in any slicing direction") {
  check_right(print({solid("bracket.lua"), "--scale", "0.5", "--direction", "1,0,0", "--port",
                     "sim:", "--layer-height", "0.3", "--certify", "off"}));
}

TEST_CASE("A CoreXY and a delta print the same part right") {
  for (const std::vector<std::string>& machine :
       {std::vector<std::string>{"--port", "sim:?kinematics=corexy&jerk=classic"},
        std::vector<std::string>{"--printer", "generic_delta", "--port", "sim:"}}) {
    std::vector<std::string> words{
        solid("bracket.lua"), "--scale", "0.4", "--layer-height", "0.3", "--certify", "off",
        "--sampling",         "0.2"};
    words.insert(words.end(), machine.begin(), machine.end());
    check_right(print(words));
  }
}

TEST_CASE("The same print twice is the same, whatever the number of threads") {
  const test::TemporaryFolder folder;
  std::vector<std::string> files;
  for (const char* threads : {"1", "3"}) {
    const auto path = (folder.path() / threads).string() + ".gcode";
    const auto done = test::slipstick(
        {"slice", solid("bracket.lua"), "--scale", "0.3", "--threads", threads, "-o", path});
    REQUIRE(done.status == 0);
    files.push_back(test::run({"cat", path}).out);
  }

  CHECK(files[0].size() > 10'000);
  CHECK(files[0] == files[1]);
}

TEST_CASE("Contours of the example pass an independent check, and planted faults do not") {
  const test::TemporaryFolder folder;
  const std::string good = (folder.path() / "good.jsonl").string();
  const std::string bad = (folder.path() / "bad.jsonl").string();
  const std::string model = solid("schwarz_cube.lua");
  REQUIRE(test::slipstick({"slice", model, "-o", good, "--layers", "20:24"}).status == 0);
  const auto verified = [&](const std::string& file) {
    return test::slipstick({"verify", file, "--against", model}).status;
  };

  CHECK(verified(good) == 0);
  for (const char* fault : {R"(2s/"depth":1/"depth":2/)", R"(3s/\[\([0-9.]*\),/[9\1,/)",
                            R"(2s/{"depth":1,"points":\[[^}]*},//)"}) {
    INFO(fault);
    const std::string planted = test::run({"sed", fault, good}).out;
    std::ofstream(bad) << planted;
    REQUIRE(planted != test::run({"cat", good}).out);

    CHECK(verified(bad) == 1);
  }
}

TEST_CASE("Real models print right") {
  const char* folder = std::getenv("SLIPSTICK_MODELS");
  if (folder == nullptr) {
    WARN("skipped: SLIPSTICK_MODELS is not set");
    return;
  }
  for (const char* name : {"bunny_closed_75k.ply", "fidget_bear.vm", "fidget_colonnade.vm"}) {
    const auto path = std::filesystem::path(folder) / name;
    if (!std::filesystem::exists(path)) {
      WARN("skipped: " << path << " is not there");
      continue;
    }
    INFO(name);
    check_right(print({path.string(), "--fit", "24,24,24", "--port", "sim:", "--certify", "off"}));
  }
}
