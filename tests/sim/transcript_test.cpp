// The simulated printer against written dialogues: those of tests/corpus/dialogue, and what a real
// board said where SLIPSTICK_TRANSCRIPTS names a folder of such.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/support/transcript_player.h"

using namespace slipstick;
using test::play_transcript;
using test::read_transcript;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<test::Difference> differences(const char* text) {
  return play_transcript(read_transcript(text), {});
}

}  // namespace

TEST_CASE("The simulated printer says what the dialogues say") {
  int count = 0;
  const auto folder = std::filesystem::path(SLIPSTICK_SOURCE_DIR) / "tests/corpus/dialogue";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++count;
    INFO(entry.path().filename());
    const auto lines = read_transcript(content(entry.path()));
    REQUIRE(lines.size() > 1);
    for (const auto& d : play_transcript(lines, {})) FAIL_CHECK(text_of(d));
  }
  CHECK(count >= 8);
}

namespace {

constexpr const char* kWritten =
    "# how it begins\n"
    "  0.501 >> G28\n"
    "2 << echo:busy\\r\n"
    "## control: flip-rx 1\n"
    "> a\\nb\\x00\\\\\\n\n"
    "\n"
    "! reset\n"
    "anything else\n";

}  // namespace

TEST_CASE("A dialogue is read with its marks and bytes") {
  const auto lines = read_transcript(kWritten);

  using Kind = test::TranscriptLine::Kind;
  REQUIRE(lines.size() == 5);
  const auto is = [&](std::size_t i, Kind kind, const std::string& text) {
    return lines[i].kind == kind && lines[i].text == text;
  };
  CHECK(is(0, Kind::kHost, "G28\n"));
  CHECK(is(1, Kind::kPrinter, "echo:busy\r"));
  CHECK(is(2, Kind::kBench, "flip-rx 1"));
  CHECK(is(3, Kind::kHost, std::string("a\nb\0\\\n", 6)));
  CHECK(is(4, Kind::kBench, "reset"));
}

TEST_CASE("A dialogue is read with its times and lines") {
  const auto lines = read_transcript(kWritten);

  REQUIRE(lines.size() == 5);
  CHECK(lines[0].at == Moment(501'000));
  CHECK(lines[0].number == 2);
  CHECK_FALSE(lines[4].at);
}

TEST_CASE("Another word, a missing one, one too many and one too late are differences") {
  CHECK(differences("> M110 N5\n< ok\n> M119\n< ok\n").front().line == 3);
  CHECK(differences("> M110 N5\n< ok\n< ok\n").front().heard == "nothing");
  CHECK(differences("> M110 N5\n").front().expected == "nothing");
  CHECK(differences("5 > G4 S3\n7 < echo:busy: processing\n8.0 < ok\n").empty());
  CHECK(differences("5 > G4 S3\n7 < echo:busy: processing\n8.3 < ok\n").size() == 1);
}

TEST_CASE("Temperatures may be off by the noise of the sensor and a part of the rise") {
  const test::Tolerance tolerance;
  const auto same = [&](const char* a, const char* b) { return says_the_same(a, b, tolerance); };

  CHECK(same("ok T:22.00 /0.00 B:22.00 /0.00 @:0 B@:0", "ok T:21.80 /0.00 B:22.20 /0.00 @:9 B@:9"));
  CHECK(same(" T:122.00 /130.00 W:9", " T:125.00 /130.00 W:8"));
  CHECK_FALSE(same("ok T:22.00 /0.00", "ok T:22.30 /0.00"));
  CHECK_FALSE(same("ok T:22.00 /0.00", "ok T:22.00 /0.20"));
  CHECK_FALSE(same(" T:122.00 W:?", " T:122.00 W:9"));
  CHECK_FALSE(same("ok", "ok T:22.00"));
}

namespace {

/// How a real dialogue is played, and why the simulator differs behind the lines where it does.
struct RealDialogue {
  struct Reason {
    int line;
    const char* why;
  };
  /// What was done to the printer behind a line, and not written down.
  struct Deed {
    int behind;
    Moment at;
    const char* words;
  };
  const char* name;
  int baud = 0;
  std::vector<Reason> reasons = {};
  std::vector<Deed> deeds = {};
  HeaterOptions nozzle = nozzle_options();  ///< As measured in the dialogue.
  int from = 1;                             ///< The first line that is replayed.
  int speed = 1;                            ///< How much faster that board's clock went.
};

// Marlin 2.1.2, built as a process of its own; a second in it is one of the machine's clock.
constexpr const char* kLate = "how far it moves depends on when the line was read, to 4 ms";
constexpr const char* kKeeps = "a little above the room that board's nozzle keeps its heat longer";
constexpr const char* kSettles = "nearing its target it is 2 °C or 1 s off: the controls' beats";
constexpr const char* kAveraged = "that board averages its sensor: it is 0.2 to 0.3 s later";
constexpr const char* kStillHeated = "that bench cut the power more than a second after it said so";
constexpr const char* kMorePower = "a stuck heater there has half as much again as its full power";
// That board's steps are signals, each armed when the last was served (Marlin 2.1.2, HAL/LINUX
// Timer.cpp), so that what it is late by adds up: one and the same homing took it 15.25, 15.32,
// 15.36, 15.39, 15.48 and 15.69 s in six dialogues.
constexpr const char* kSlow =
    "the board lost 0.3 s, less than the 0.44 s by which its homing varies";
constexpr const char* kChunks = "that board reads a whole line at a time, and flushes between";
constexpr const char* kAhead = "the host went on before the ok had come";
constexpr const char* kByte = "that bench harmed another byte of the line";
constexpr const char* kBehind = "its clock, five times as fast, fell behind";
constexpr const char* kStarting = "the host asked before that board had started";
constexpr const char* kTransmitter = "that board has a transmit buffer and flushes without waiting";

std::vector<RealDialogue> real_dialogues() {
  return {{"banner", 0, {}},
          {"errors"},
          {"cold"},
          {"m108", 0, {{20, kKeeps}, {46, kLate}}},
          {"m112"},
          {"arcs", 0, {{13, kSlow}}},
          {"heat", 0, {{14, kSettles}, {75, kSettles}}},
          {"window", 0, {{24, kChunks}, {46, kChunks}}},
          {"window-uart", 115200, {{24, kTransmitter}, {55, kTransmitter}}},
          {"job2000"},
          {"faults", 0, {{68, kAveraged}, {105, kStillHeated}, {181, kMorePower}}},
          {"wire"},
          {.name = "printcore-noise",
           .baud = 115200 / 5,
           .reasons = {{34, kStarting},
                       {37, kBehind},
                       {506, kAhead},
                       {511, kAhead},
                       {514, kAhead},
                       {515, kAhead},
                       {2506, kByte},
                       {2686, kByte},
                       {3574, kByte},
                       {3664, kByte}},
           .from = 7,
           .speed = 5},
          {.name = "faults2",
           .reasons = {{63, kAveraged}},
           .deeds = {{30, Moment(4'900'000), "nozzle open"},
                     {110, Moment(30'580'000), "nozzle cold"},
                     {173, Moment(1'806'000), "reset"},
                     {200, Moment(1'865'000), "reset"}},
           .nozzle = {.rise_max = 17.5 * 155, .time_constant = 155}}};
}

// The control of a heater goes on its own beat, which no dialogue tells: the nozzle's each 0.164 s,
// in which it gains 0.66 °C, the bed's each 5 s, in which it gains 6.5 °C.
constexpr test::Tolerance kReal{.celsius = 0.25 + 0.66, .bed_celsius = 0.25 + 6.5};

void check_real(const std::filesystem::path& folder, const RealDialogue& dialogue) {
  PrinterOptions options;
  options.baud = dialogue.baud;
  options.machine.nozzle = dialogue.nozzle;
  options.machine.build_volume = {200, 200, 200};
  const auto file = folder / (std::string("marlin-2.1.2-") + dialogue.name + ".txt");
  auto lines = read_transcript(content(file));
  INFO(file);
  REQUIRE(lines.size() > 1);
  std::erase_if(lines, [&](const auto& line) { return line.number < dialogue.from; });
  for (auto& line : lines) {
    if (line.at) *line.at *= dialogue.speed;
  }
  for (const RealDialogue::Deed& deed : dialogue.deeds) {
    const auto behind = std::find_if(lines.begin(), lines.end(),
                                     [&](const auto& line) { return line.number > deed.behind; });
    lines.insert(behind, {test::TranscriptLine::Kind::kBench, deed.at, deed.words, deed.behind});
  }
  for (auto& line : lines) {
    if (line.text.starts_with("hotend ")) line.text.replace(0, 6, "nozzle");
  }
  test::Tolerance tolerance = kReal;
  tolerance.seconds *= dialogue.speed;
  std::map<int, std::string> found;
  for (const auto& d : play_transcript(lines, options, tolerance)) found[d.line] = text_of(d);
  for (const auto& reason : dialogue.reasons) {
    if (found.erase(reason.line) == 0) FAIL_CHECK("line " << reason.line << " does not differ");
  }
  for (const auto& [line, text] : found) FAIL_CHECK(text);
}

}  // namespace

TEST_CASE("The simulated printer says what a real one said, but for what is explained") {
  const char* folder = std::getenv("SLIPSTICK_TRANSCRIPTS");
  if (folder == nullptr) {
    WARN("skipped: SLIPSTICK_TRANSCRIPTS is not set");
    return;
  }
  for (const RealDialogue& dialogue : real_dialogues()) check_real(folder, dialogue);
}
