// Programs that are odd, broken, or cannot be read to their end.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "host/file_lines.h"
#include "tests/host/recorded_print.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

struct Program {
  explicit Program(std::string_view text) { std::ofstream(path, std::ios::binary) << text; }

  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> read;
    const auto file = FileLines::open(path);
    REQUIRE(file);
    for (auto line = (*file)->next();; line = (*file)->next()) {
      INFO((line ? "" : line.error().message));
      REQUIRE(line);
      if (!*line) return read;
      read.push_back((*line)->text());
    }
  }
  [[nodiscard]] std::string fault() const {
    const auto count = FileLines::check(path);
    return count ? "" : count.error().message;
  }

  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.gcode";
};

/// Lines, and then a fault.
class FailingLines final : public LineSource {
 public:
  Result<std::optional<Line>> next() override {
    constexpr int kGood = 50;
    if (given_++ == kGood) return fail(ErrorCode::kUnavailable, "the card cannot be read");
    return normalise(given_ == 1 ? "M104 S100" : given_ % 2 == 0 ? "G1 X1 F6000" : "G1 X2 F6000");
  }
  bool ready() const override { return true; }

 private:
  int given_ = 0;
};

}  // namespace

TEST_CASE("Lines end as they like, the last one with nothing") {
  for (const char* text :
       {"G28\nG1 X1\n\nG1 X2", "G28\r\nG1 X1\r\n\r\nG1 X2\r\n", "G28\rG1 X1\r\rG1 X2\r",
        "G28\r\nG1 X1\rG1 X2\n", "\xef\xbb\xbfG28\nG1 X1;\xc3\xbc\nG1 X2"}) {
    CHECK(Program(text).lines() == std::vector<std::string>{"G28", "G1 X1", "G1 X2"});
  }
  CHECK(Program("").lines().empty());
  CHECK(Program("\r\n\n\r").lines().empty());
}

TEST_CASE("A fault of a program is found before the print, with its line") {
  CHECK_THAT(Program("G28\r\nG1 X1\r\nM112\n").fault(),
             Contains("a.gcode:3: ") && Contains("it stops the printer"));
  CHECK_THAT(Program("G28\rG1 X\xc3\xbc\r").fault(), Contains("a.gcode:2: "));
  CHECK_THAT(Program("G28\n@pause\n").fault(), Contains("a.gcode:2: ") && Contains("M600"));
  CHECK(Program("G28\nM117 \xc3\xbc\n").fault().empty());
}

TEST_CASE("A program that is refused sends the printer nothing") {
  const Program program("M104 S200\n" + std::string(3000, '\n') + "M28 x.gco\n");
  const auto done = test::slipstick({"print", program.path.string(), "--port", "pty:/no/printer"});

  CHECK(done.status == 1);
  CHECK_THAT(done.err, Contains("a.gcode:3002: ") && Contains("the printer's own card"));
}

TEST_CASE("A file without line ends is no program, and takes no memory") {
  const Program program(std::string(1 << 22, 'x'));

  CHECK_THAT(program.fault(), Contains("a line of more than 65536 bytes"));
  CHECK(Program("G28 ;" + std::string(60'000, 'x')).lines() == std::vector<std::string>{"G28"});
}

// The memory of this process: it opens, and its first page cannot be read.
TEST_CASE("A file that cannot be read any further is an error, not an end") {
  const auto file = FileLines::open("/proc/self/mem");
  REQUIRE(file);
  const auto line = (*file)->next();

  REQUIRE(!line);
  CHECK(line.error().code == ErrorCode::kUnavailable);
}

TEST_CASE("A program whose rest cannot be read ends the print with the heaters off") {
  SimTransport sim(*sim_options({}));
  FailingLines lines;
  const auto outcome = stream_job(sim, sim.clock(), lines, {Pace::kVirtual, {}});

  REQUIRE(!outcome);
  CHECK(outcome.error().message == "the card cannot be read; heaters are off");
  CHECK(sim.printer().machine().nozzle.off());
}

TEST_CASE("A printer whose name is no text does not break the report") {
  const Program program("M302 S0\nG1 X1 F6000\n");
  const auto done = test::slipstick({"print", program.path.string(), "--json", "--port",
                                     "sim:?fault=say=FIRMWARE_NAME:A\x94\xff@line5"});

  INFO(done.err);
  CHECK(done.status == 0);
  CHECK_THAT(done.out, Contains("\"firmware\": \"A"));
}
