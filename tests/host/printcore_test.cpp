// A host program that is not ours on the simulated printer behind a terminal: Printrun's printcore
// (Debian package printcore) prints what the file says, over a good cable and a bad one.
#include <catch2/catch.hpp>
#include <fstream>
#include <thread>

#include "sim/gcode_player.h"
#include "sim/pty_server.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;

namespace {

constexpr double kSpeed = 200;

struct Placed {
  Axes from;
  Axes to;

  friend bool operator==(const Placed&, const Placed&) = default;
};

Planner::Sink into(std::vector<Placed>& moves) {
  return [&moves](const ExecutedMove& move) { moves.push_back({move.from, move.to}); };
}

bool has_printcore() {
  if (test::run({"/bin/sh", "-c", "command -v printcore"}).status == 0) return true;
  WARN("skipped: printcore is not installed");
  return false;
}

/// A few layers of a lattice.
std::string sliced(const test::TemporaryFolder& folder) {
  const std::string path = (folder.path() / "part.gcode").string();
  const auto done = test::slipstick(
      {"slice", SLIPSTICK_SOURCE_DIR "/configs/solids/schwarz_cube.lua", "--scale", "0.2",
       "--layer-height", "0.3", "--layers", "0:4", "--certify", "off", "-o", path});
  INFO(done.err);
  REQUIRE(done.status == 0);
  return path;
}

/// What the machine does when it is given the program without a wire.
std::vector<Placed> played(const std::string& path) {
  std::vector<Placed> moves;
  GcodePlayer player({220, 220, 250}, into(moves));
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) player.play(line);
  player.finish();
  CHECK(player.refused() == 0);
  return moves;
}

struct Outcome {
  std::vector<Placed> moves;
  PrinterStatistics statistics;
};

/// What it does when printcore prints the program on a printer with `faults`.
Outcome printed(const test::TemporaryFolder& folder, const std::string& path,
                const std::vector<FaultSpec>& faults) {
  Outcome outcome;
  PrinterOptions options;
  options.faults = faults;
  const std::string terminal = (folder.path() / "printer").string();
  auto server = PtyServer::open({.pty_path = terminal, .tcp_port = {}, .speed = kSpeed},
                                Printer(options, into(outcome.moves)));
  REQUIRE(server);
  bool failed = false;
  {
    const std::jthread running([&](const std::stop_token& stop) { failed = !server->run(stop); });
    const auto done = test::run({"/usr/bin/env", "printcore", "-b", "115200", terminal, path});
    INFO(done.out << done.err);
    CHECK(done.status == 0);
  }
  CHECK_FALSE(failed);
  outcome.statistics = server->printer().statistics();
  return outcome;
}

}  // namespace

TEST_CASE("Printcore prints a part just as its file says") {
  if (!has_printcore()) return;
  const test::TemporaryFolder folder;
  const std::string path = sliced(folder);
  const auto expected = played(path);
  REQUIRE(expected.size() > 100);

  const Outcome outcome = printed(folder, path, {});

  CHECK(outcome.moves == expected);
  CHECK(outcome.statistics.resends_requested == 0);
}

TEST_CASE("Printcore prints the same part where bits flip on the way to the board") {
  if (!has_printcore()) return;
  const test::TemporaryFolder folder;
  const std::string path = sliced(folder);

  const Outcome outcome = printed(folder, path, {FaultSpec::parse("flip-rx=0.0004@line5").value()});

  CHECK(outcome.statistics.resends_requested > 3);
  CHECK(outcome.moves == played(path));
}
