#include "sim/personality.h"

#include <catch2/catch.hpp>
#include <string>

#include "tests/sim/dialogue.h"

using namespace slipstick;

namespace {

Dialogue with(const char* firmware) {
  PrinterOptions options;
  options.personality = find_personality(firmware).value();
  return Dialogue(options);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string kWrongNumber = "Error:Line Number is not Last Line Number+1, Last Line: 0\n";

}  // namespace

TEST_CASE("A lost line is asked for as each firmware does") {
  const struct {
    const char* firmware;
    std::string heard;
  } rows[] = {
      {"marlin-1.0.2", kWrongNumber + "Resend: 1\nok\n"},
      {"marlin-1.1.9", kWrongNumber + "Resend: 1\nok\n"},
      {"marlin-2.0.7", kWrongNumber + "Resend: 1\nok\n"},
      {"marlin-2.0.8", kWrongNumber + "Resend: 1\n"},
      {"marlin-2.0.9", kWrongNumber + "Resend: 1\nok\n"},
      {"marlin-2.1.2", kWrongNumber + "Resend: 1\nok\n"},
      {"prusa-mk3", kWrongNumber + "Resend: 1\nok\n"},
      {"creality", kWrongNumber + "Resend: 1\nok\n"},
      {"repetier", "Error:expected line 1 got 7\n\nResend:1\nok\n"},
      {"smoothieware", "rs N1\n"},
      {"reprapfirmware", "ok\n"},
      {"klipper", "ok\n"},
  };
  for (const auto& row : rows) {
    INFO(row.firmware);
    Dialogue dialogue = with(row.firmware);
    CHECK(dialogue.say("N7 M117*35") == row.heard);
  }
}

TEST_CASE("A number sent twice means what each firmware takes it for") {
  const struct {
    const char* firmware;
    std::string heard;
  } rows[] = {
      {"marlin-2.0.9",
       "Error:Line Number is not Last Line Number+1, Last Line: 1\nResend: 2\nok\n"},
      {"marlin-2.1.2", ""},
      {"repetier", "skip 1\nok\n"},
      {"smoothieware", "rs N2\n"},
      {"reprapfirmware", "ok\n"},
      {"klipper", "ok\n"},
  };
  for (const auto& row : rows) {
    INFO(row.firmware);
    Dialogue dialogue = with(row.firmware);
    REQUIRE(dialogue.say("N1 M117*37") == "ok\n");
    CHECK(dialogue.say("N1 M117*37") == row.heard);
  }
}

TEST_CASE("A damaged line is lost without a word where nobody asks again") {
  CHECK(with("reprapfirmware").say("N1 M117*36").empty());
  CHECK(with("klipper").say("N1 M117*36") == "ok\n");
  CHECK(with("repetier").say("N1 M117*36") == "Error:Wrong checksum\n\nResend:1\nok\n");
}

TEST_CASE("A checksum without a number is refused by Marlin 1.0 and Prusa only") {
  const std::string error = "Error:No Line Number with checksum, Last Line: 0\n";

  CHECK(with("marlin-1.0.2").say("M117*1") == error);
  CHECK(with("prusa-mk3").say("M117*1") == error + "Resend: 1\nok\n");
  CHECK(with("marlin-1.1.9").say("M117*1") == "ok\n");
}

TEST_CASE("Marlin 1.0 takes any N for a line number") {
  CHECK(has(with("marlin-1.0.2").say("M117 No news"), "Resend: 1\n"));
  CHECK(with("marlin-1.1.9").say("M117 No news") == "ok\n");
}

TEST_CASE("The checksum follows the last star, with older firmwares the first") {
  const char* const line = "N1 M117 a*b*44";  // Its sum is that of all before the last star.

  CHECK(has(with("marlin-1.0.2").say(line), "checksum mismatch"));
  CHECK(has(with("prusa-mk3").say(line), "checksum mismatch"));
  CHECK(with("marlin-2.1.2").say(line) == "ok\n");
}

TEST_CASE("Repetier acknowledges what it has received, others what they have done") {
  CHECK(with("marlin-2.1.2").say("G4 P500").empty());
  CHECK(with("repetier").say("G4 P500") == "ok\n");
  CHECK(with("repetier").say("M105") == "ok\nT:22.00 /0.00 B:22.00 /0.00 @:0 B@:0\n");
}

TEST_CASE("Repetier says wait each second in which there is nothing to do") {
  Dialogue idle = with("repetier");
  idle.say("M117");

  CHECK(idle.listen(3 * kSecond) == "wait\nwait\nwait\n");
  CHECK(with("marlin-2.1.2").listen(3 * kSecond).empty());
}

TEST_CASE("Keep-alive has the words of the firmware or is missing") {
  CHECK(with("marlin-2.1.2").say("G4 S3", 3 * kSecond) == "echo:busy: processing\nok\n");
  CHECK(has(with("repetier").say("G4 S3", 3 * kSecond), "\nbusy:processing\n"));
  CHECK(with("marlin-1.0.2").say("G4 S3", 2 * kSecond).empty());
  CHECK(with("klipper").say("G4 S3", 2 * kSecond).empty());
}

TEST_CASE("M112 overtakes only in the form that the firmware compares with") {
  const auto stops = [](const char* firmware, const std::string& line) {
    Dialogue dialogue = with(firmware);
    dialogue.say("G4 S60");
    dialogue.say(line);
    return dialogue.printer().machine().halted;
  };

  CHECK(stops("marlin-2.1.2", "M112 now"));
  CHECK_FALSE(stops("marlin-2.1.2", "N1 M112*32"));
  CHECK(stops("marlin-1.1.9", "M112"));
  CHECK_FALSE(stops("marlin-1.1.9", "M112 now"));
  CHECK(stops("prusa-mk3", "N1 M112*32"));
}

TEST_CASE("M115 and the last words name the firmware") {
  CHECK(with("klipper").say("M115") == "ok FIRMWARE_VERSION:v0.12 FIRMWARE_NAME:Klipper\n");
  CHECK(has(with("repetier").say("M115"), "FIRMWARE_NAME:Repetier_"));
  CHECK(has(with("marlin-2.0.7").say("M115"), "Cap:ARCS:1\n"));
  CHECK_FALSE(has(with("marlin-1.1.9").say("M115"), "Cap:ARCS"));
  CHECK_FALSE(has(with("creality").say("M115"), "Cap:"));
  CHECK(with("marlin-2.0.9").say("M112") == "Error:Printer halted. kill() called!\n");
  CHECK(with("klipper").say("M112") == "!! Shutdown due to M112 command\n");
}

TEST_CASE("A firmware keeps its personality through a reset") {
  Dialogue dialogue = with("smoothieware");
  dialogue.printer().reset();

  CHECK(dialogue.listen(kSecond) == "Smoothie\nok\n");
}

TEST_CASE("Every name that users are told exists") {
  CHECK(personality_names().starts_with("marlin-1.0.2, marlin-1.1.9, "));
  CHECK_FALSE(find_personality("marlin"));
  CHECK(default_personality().name == "marlin-2.1.2");
}
