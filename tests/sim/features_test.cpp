// What a firmware can be built with beyond Marlin's default configuration.
#include "sim/features.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "sim/meat_pack.h"
#include "sim/sd_card.h"
#include "sim/sim_options.h"
#include "tests/sim/dialogue.h"

using namespace slipstick;
using Catch::Contains;

namespace {

Dialogue with(const std::string& features) {
  return Dialogue(sim_options({{"with", features}})->printer);
}

std::string numbered(int number, const std::string& command) {
  const std::string line = "N" + std::to_string(number) + " " + command;
  unsigned sum = 0;
  for (const char c : line) sum ^= static_cast<unsigned char>(c);
  return line + "*" + std::to_string(sum & 0xFFU);
}

std::string unpacked(MeatPack& pack, std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) {
    const auto out = pack.feed(byte);
    text.append(out.data(), out.size());
  }
  return text;
}

std::string command_bytes(unsigned char command) {
  return {'\xFF', '\xFF', static_cast<char>(command)};
}

/// The slow obvious packer: two characters a byte, line ends fill a byte up.
std::string packed(const std::string& text, bool no_spaces) {
  const std::string alphabet = std::string("0123456789.") + (no_spaces ? 'E' : ' ') + "\nGX";
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const char a = text[i];
    const bool alone = a == '\n';
    const char b = alone || i + 1 == text.size() ? '\n' : text[i + 1];
    const std::size_t first = std::min<std::size_t>(alphabet.find(a), 15);
    const std::size_t second = std::min<std::size_t>(alphabet.find(b), 15);
    bytes += static_cast<char>(first | second << 4U);
    if (first == 15) bytes += a;
    if (second == 15) bytes += b;
    if (alone) --i;
  }
  return bytes;
}

std::string any_line(Rng& rng) {
  if (rng.below(10) == 0) return command_bytes(static_cast<unsigned char>(rng.below(256)));
  std::string line = (rng.below(4) == 0 ? "G" : "M") + std::to_string(rng.below(1000));
  for (std::uint64_t n = rng.below(4); n > 0; --n) {
    line += std::string(" ") + static_cast<char>('A' + rng.below(26));
    if (rng.below(3) > 0) line += std::to_string(static_cast<int>(rng.below(400)) - 100);
  }
  return line;
}

void disturb(Dialogue& dialogue, Rng& rng) {
  if (rng.below(20) == 0) dialogue.printer().run_out_of_filament();
  if (rng.below(10) == 0) dialogue.printer().press_button();
  dialogue.say(any_line(rng), 20 * kSecond);
  if (dialogue.printer().machine().halted) dialogue.printer().reset();
}

}  // namespace

TEST_CASE("With ADVANCED_OK an acknowledgement tells its line and what room there is") {
  Dialogue dialogue = with("advanced-ok");

  CHECK(dialogue.say("G21") == "ok P15 B3\n");
  CHECK(dialogue.say(numbered(1, "G21")) == "ok N1 P15 B3\n");
  // Four moves are queued one after the other, the command behind waits in the queue.
  CHECK(dialogue.send("G1 X1\nG1 X2\nG1 X3\nG1 X4\n", Moment(0)) ==
        "ok P14 B0\nok P13 B1\nok P12 B2\nok P11 B3\n");
  CHECK_THAT(dialogue.say("M105"), Catch::StartsWith("ok T:"));
}

TEST_CASE("MeatPack is off until it is asked for, and says what it is") {
  MeatPack pack;
  CHECK(unpacked(pack, "G1 X10\n") == "G1 X10\n");
  CHECK(unpacked(pack, command_bytes(0xFB)).empty());
  CHECK(pack.take_text() == "[MP] PV01 ON ESP\n");
  unpacked(pack, command_bytes(0xF7));
  unpacked(pack, command_bytes(0xF8));
  CHECK(pack.take_text() == "[MP] PV01 ON NSP\n[MP] PV01 ON NSP\n");
  unpacked(pack, command_bytes(0xF9));
  CHECK(pack.take_text() == "[MP] PV01 OFF ESP\n");
}

TEST_CASE("MeatPack gives back two characters a byte, literals in between") {
  MeatPack pack;
  unpacked(pack, command_bytes(0xFB));

  // "G1" is 13 and 1, " X" 11 and 14, "5\n" 5 and 12.
  CHECK(unpacked(pack, "\x1D\xEB\xC5") == "G1 X5\n");
  // "M1": a literal and a 1; "*7": the same; both literal: "MY".
  CHECK(unpacked(pack, "\x1FM") == "M1");
  CHECK(unpacked(pack, "\xF7*") == "7*");
  CHECK(unpacked(pack, "\xFFMY") == "MY");
}

TEST_CASE("Whatever is packed comes out as it was") {
  Rng rng(3);
  for (int round = 0; round < 500; ++round) {
    const bool no_spaces = round % 2 == 1;
    MeatPack pack;
    unpacked(pack, command_bytes(0xFB));
    if (no_spaces) unpacked(pack, command_bytes(0xF7));
    const std::string alphabet = no_spaces ? "0123456789.E\nGXYMN*;-" : "0123456789. \nGXYEMN*;-";
    std::string text;
    for (std::uint64_t n = rng.below(60); n > 0; --n) text += alphabet[rng.below(alphabet.size())];
    text += '\n';
    INFO(text);
    CHECK(unpacked(pack, packed(text, no_spaces)) == text);
  }
}

TEST_CASE("A board with MeatPack obeys packed lines") {
  Dialogue dialogue = with("meatpack");
  CHECK(dialogue.send(command_bytes(0xFB)) == "[MP] PV01 ON ESP\n");
  CHECK(dialogue.send(packed(numbered(1, "G92 X5") + "\n", false)) ==
        "X:5.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0\nok\n");
  CHECK_THAT(dialogue.send(packed("M115\n", false)), Contains("Cap:MEATPACK:1"));
  dialogue.printer().reset();
  dialogue.listen(kSecond);
  CHECK(dialogue.say("G21") == "ok\n");
}

TEST_CASE("A card takes files, lists them, prints them and throws them away") {
  Dialogue dialogue = with("sd-card");
  CHECK(dialogue.say("M20") == "Begin file list\nEnd file list\nok\n");
  CHECK(dialogue.say("M23 gone.gco") == "open failed, File: GONE.GCO.\nok\n");
  CHECK(dialogue.say(numbered(1, "M28 part.gco")) == "Writing to file: PART.GCO\nok\n");
  CHECK(dialogue.say(numbered(2, "G92 X7")) == "ok\n");
  CHECK(dialogue.say("G4 P100") == "ok\n");
  CHECK(dialogue.say("M29") == "Done saving file.\nok\n");
  CHECK(dialogue.say("M20") == "Begin file list\nPART.GCO 15\nEnd file list\nok\n");

  CHECK(dialogue.say("M24") == "ok\n");  // nothing is selected
  CHECK(dialogue.say("M27") == "Not SD printing\nok\n");
  CHECK_THAT(dialogue.say("M23 PART.GCO"), Contains("Size: 15\nFile selected\nok\n"));
  CHECK(dialogue.say("M24", kSecond) ==
        "ok\nX:7.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0\nDone printing file\n");
  CHECK(dialogue.say("M30 PART.GCO") == "File deleted:PART.GCO\nok\n");
  CHECK(dialogue.say("M30 PART.GCO") == "Deletion failed, File: PART.GCO\nok\n");
  CHECK(Dialogue().say("M20") == "echo:Unknown command: \"M20\"\nok\n");
}

TEST_CASE("A card that is printed from can be emptied, and it can be full") {
  SdCard card;
  static_cast<void>(card.run(*parse_gcode("M28 A.GCO")));
  const std::string line(1000, 'x');
  for (int i = 0; i < 5000; ++i) CHECK(card.writes(line));
  static_cast<void>(card.run(*parse_gcode("M29")));
  CHECK_FALSE(card.writes(line));
  static_cast<void>(card.run(*parse_gcode("M23 A.GCO")));
  static_cast<void>(card.run(*parse_gcode("M24")));
  CHECK(card.next()->line == line);
  CHECK_THAT(*card.run(*parse_gcode("M27")), Contains("SD printing byte 1001/419"));
  static_cast<void>(card.run(*parse_gcode("M30 A.GCO")));
  CHECK_FALSE(card.next());
}

TEST_CASE("What is stored in the EEPROM outlives a reset") {
  CHECK(Dialogue().say("M500") == "Error:EEPROM disabled\nok\n");

  Dialogue dialogue = with("eeprom");
  dialogue.say("M203 X123");
  CHECK_THAT(dialogue.say("M500"), Contains("echo:Settings Stored (") && Contains("; crc "));
  dialogue.say("M203 X99");
  dialogue.printer().reset();
  dialogue.listen(kSecond);
  CHECK_THAT(dialogue.say("M203"), Contains("M203 X123.00"));
  dialogue.say("M502");
  CHECK_THAT(dialogue.say("M203"), Contains("M203 X300.00"));
  CHECK_THAT(dialogue.say("M501", kSecond),
             Contains("stored settings retrieved (") && Contains("M203 X123.00"));
}

TEST_CASE("G29 measures the grid that M420 shows") {
  Dialogue dialogue = with("bed-leveling");
  CHECK(dialogue.say("G29") == "echo:Home XYZ First\nok\n");
  CHECK_THAT(dialogue.say("M420 V S1"),
             Contains("Error:Failed to enable Bed Leveling\n") &&
                 Contains(" 0  =====  =====  =====\n") &&
                 Contains("echo:Bed Leveling OFF\necho:Fade Height 10.00\n"));
  dialogue.say("G28", 20 * kSecond);

  const std::string probing = dialogue.say("G29", 30 * kSecond);
  CHECK_THAT(probing, Contains("busy: processing") && !Contains("ok"));
  CHECK_THAT(dialogue.listen(5 * kSecond), Contains("Bilinear Leveling Grid:\n") &&
                                               Contains(" 1 -0.050 +0.120 +0.050\n") &&
                                               Contains("ok\n"));
  CHECK_THAT(dialogue.say("M420 Z0"), Contains("echo:Bed Leveling ON\necho:Fade Height OFF\n"));
}

TEST_CASE("Waiting for heat begins a job, the last heater off ends it") {
  Dialogue dialogue;
  CHECK(dialogue.say("M31") == "echo:Print time: 0s\nok\n");
  dialogue.say("M140 S60");
  CHECK(dialogue.say("M31") == "echo:Print time: 0s\nok\n");
  dialogue.say("M190 S60", Moment(3'700) * 1'000'000);
  CHECK_THAT(dialogue.say("M31"), Contains("Print time: 1h 1m 40s"));
  dialogue.say("M140 S0", 100 * kSecond);
  CHECK_THAT(dialogue.say("M31"), Contains("Print time: 1h 1m 40s"));

  dialogue.say("M75", 65 * kSecond);
  dialogue.say("M76", 65 * kSecond);
  CHECK_THAT(dialogue.say("M31"), Contains("Print time: 1m 5s"));
  dialogue.say("M77");
}

TEST_CASE("Positions report themselves where the firmware can") {
  CHECK_THAT(Dialogue().say("M154 S1"), Contains("Unknown command"));
  Dialogue dialogue = with("position-reports,progress");
  CHECK(dialogue.say("M73 P10 R5") == "ok\n");
  dialogue.say("M154 S1");
  CHECK(dialogue.listen(Moment(2'500'000)) ==
        "X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0\n"
        "X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0\n");
  dialogue.say("M154 S0");
  CHECK(dialogue.listen(5 * kSecond).empty());
}

TEST_CASE("A noisy sensor is off by as much as it is said to be, and the nozzle still gets hot") {
  Dialogue dialogue(sim_options({{"noise", "0.8"}})->printer);
  double most = 0;
  for (int i = 0; i < 100; ++i) {
    dialogue.listen(Moment(300'000));
    most = std::max(most, std::abs(dialogue.printer().machine().nozzle.celsius() - 22));
  }
  CHECK(most > 0.5);
  CHECK(most <= 0.8);
  CHECK_THAT(dialogue.say("M109 S200", 300 * kSecond), Contains("ok\n"));
}

TEST_CASE("The fan costs the nozzle heat that more power makes up for") {
  const auto power_held = [](const char* fan) {
    Dialogue dialogue;
    dialogue.say(fan);
    dialogue.say("M109 S200", 300 * kSecond);
    CHECK(dialogue.printer().machine().nozzle.celsius() == Approx(200).margin(1));
    double sum = 0;
    for (int i = 0; i < 100; ++i) {
      dialogue.listen(Moment(200'000));
      sum += dialogue.printer().machine().nozzle.power();
    }
    return sum / 100;
  };

  // (200 - 22) / 380 of full power, and a tenth more.
  CHECK(power_held("M107") == Approx(127 * 178 / 380.0).margin(1.5));
  CHECK(power_held("M106") == Approx(1.1 * 127 * 178 / 380.0).margin(1.5));
}

TEST_CASE("Any lines may come to a board with everything built in: it answers and lives") {
  const std::string all =
      "advanced-ok,bed-leveling,eeprom,emergency-parser,filament-change,filament-sensor,"
      "host-prompts,linear-advance,meatpack,position-reports,progress,sd-card";
  Rng rng(11);
  for (int round = 0; round < 200; ++round) {
    Dialogue dialogue = with(all);
    for (int i = 0; i < 200; ++i) disturb(dialogue, rng);
    dialogue.printer().reset();
    dialogue.listen(kSecond);
    CHECK_THAT(dialogue.say("M117"), Catch::StartsWith("ok"));
  }
}
