// Two processes and a real terminal between them: the program prints on the simulated printer.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

std::string program(int moves) {
  std::string text = "G90\nM83\nG92 X0 Y0\n";
  for (int i = 0; i < moves; ++i) text += "G1 X" + std::to_string(i % 10 + 1) + " F6000\n";
  return text + "M400\n";
}

// Runs `then` in a shell beside a simulated printer at `place`/printer, which is ended afterwards.
test::Finished beside_printer(const std::filesystem::path& place, const std::string& options,
                              const std::string& then) {
  const std::string program = SLIPSTICK_BINARY;
  const std::string pty = (place / "printer").string();
  const std::string script = program + " sim --pty " + pty + " --options '" + options +
                             "' >/dev/null & sim=$!\n"
                             "for i in $(seq 100); do [ -e " +
                             pty + " ] && break; sleep 0.05; done\n" + program + " " + then +
                             " --port pty:" + pty +
                             "\nstatus=$?\nkill $sim\nwait $sim\nexit $status\n";
  return test::run({"sh", "-c", script});
}

}  // namespace

TEST_CASE("A G-code file reaches a printer behind a terminal, every line once") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "moves.gcode", report = folder.path() / "report.json";
  std::ofstream(path) << program(60);

  const auto done =
      beside_printer(folder.path(), "", "print " + path.string() + " --report " + report.string());

  INFO(done.err);
  REQUIRE(done.status == 0);
  const auto json = nlohmann::json::parse(std::ifstream(report));
  CHECK(json["printer"]["lines_acknowledged"] == 64);
  CHECK_THAT(json["printer"]["firmware"].get<std::string>(), Contains("Marlin 2.1.2"));
}

TEST_CASE("A noisy terminal loses no line") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "moves.gcode";
  std::ofstream(path) << program(100);

  const auto done =
      beside_printer(folder.path(), "seed=6&corrupt=0.002", "print " + path.string() + " --json");

  INFO(done.err);
  REQUIRE(done.status == 0);
  CHECK(nlohmann::json::parse(done.out)["printer"]["lines_acknowledged"] == 104);
}

TEST_CASE("A printer that is not there is named") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "moves.gcode";
  std::ofstream(path) << program(1);

  const auto done = test::slipstick({"print", path.string(), "--port", "pty:/nowhere/printer"});

  CHECK(done.status == 1);
  CHECK_THAT(done.err, Contains("/nowhere/printer"));
}
