#include "drivers/marlin/reply.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"

namespace slipstick {
namespace {

template <typename Kind>
Kind read(std::string_view line) {
  const Reply reply = parse_reply(line);
  INFO(line);
  REQUIRE(std::holds_alternative<Kind>(reply));
  return std::get<Kind>(reply);
}

TEST_CASE("ok is read with everything Marlin puts behind it") {
  CHECK(read<Ok>("ok").bare);
  CHECK(read<Ok>("  ok ").bare);
  const Ok advanced = read<Ok>("ok N4 P13 B3");
  CHECK(advanced.line == 4);
  CHECK(advanced.free_moves == 13);
  CHECK(advanced.free_commands == 3);
  CHECK_FALSE(advanced.bare);
  CHECK(read<Ok>("ok P15 B3").line == std::nullopt);
  const Ok report = read<Ok>("ok T:21.87 /0.00 B:22.10 /60.00 @:0 B@:0");
  REQUIRE(report.temperatures);
  CHECK(report.temperatures->hotend == HeaterReading{21.87, 0.0});
  CHECK(report.temperatures->bed == HeaterReading{22.10, 60.0});
  CHECK(report.free_commands == std::nullopt);
}

TEST_CASE("A request to send again is read in every form it has had") {
  for (const std::string_view form :
       {"Resend: 23", "Resend:23", "resend: 23", "Resend:N23", "Resend:N:23", "rs 23", "rs N23",
        "rs N23 Expected checksum 9"}) {
    CHECK(read<Resend>(form).line == 23);
  }
  CHECK(read<Resend>("Resend: ").line == std::nullopt);
}

TEST_CASE("The last line is read even from a damaged error") {
  CHECK(read<LineError>("Error:checksum mismatch, Last Line: 12").last_line == 12);
  CHECK(read<LineError>("Error:Line Number is not Last Line Number+1, Last Line: 0").last_line ==
        0);
  CHECK(read<LineError>("Er\xff:checksum mismatch, Last Line: 7").last_line == 7);
  CHECK(read<LineError>("Error:checksum mismatch, Last Line: x").last_line == std::nullopt);
}

TEST_CASE("Fatal texts are told from harmless ones") {
  for (const std::string_view fatal :
       {"Error:Printer halted. kill() called!", "!! something",
        "Error:MAXTEMP triggered, system stopped! Heater_ID: E0",
        "Error:Heating failed, system stopped! Heater_ID: bed",
        "Error:Thermal Runaway, system stopped! Heater_ID: 0",
        "Error:!! KILL caused by too much inactive time - current command: G4"}) {
    (void)read<Fatal>(fatal);
  }
  for (const std::string_view harmless : {"Error:G2/G3 bad parameters", "Error:EEPROM disabled",
                                          "Error:volume.init failed", "Error:Probing Failed"}) {
    (void)read<ErrorText>(harmless);
  }
}

TEST_CASE("Temperatures are read from reports, not from positions") {
  const auto report = read<Temperatures>(" T:21.95 /100.00 B:21.99 /0.00 @:0 B@:0 W:?");
  CHECK(report.waiting);
  CHECK(report.hotend == HeaterReading{21.95, 100.0});
  const auto tools = read<Temperatures>("T0:1 /2 T1:-15 /0 C:30 @0:0");
  CHECK(tools.tools == std::vector<HeaterReading>{{1, 2.0}, {-15, 0.0}});
  CHECK(tools.chamber == HeaterReading{30, std::nullopt});
  CHECK(std::isnan(read<Temperatures>("T:nan /0").hotend->celsius));
  CHECK(read<Temperatures>("T:2\xff.1 /0 B:60.00 /60.00").hotend == std::nullopt);
  (void)read<Unknown>("Count A:0 B:0 C:0");
  (void)read<PositionReport>("X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0");
}

TEST_CASE("The rest of what Marlin says has its kind") {
  CHECK(read<Busy>("echo:busy: paused for user").reason == "paused for user");
  CHECK(read<Busy>("busy:processing").reason == "processing");
  CHECK(read<Action>("//action:pause").text == "pause");
  CHECK(read<Action>("// action:cancel").text == "cancel");
  CHECK(read<Echo>("echo: cold extrusion prevented").text == "cold extrusion prevented");
  (void)read<UnknownCommand>("echo:Unknown command: \"L1 M114\"");
  (void)read<Start>("start");
  (void)read<Wait>("wait");
  CHECK(read<Capability>("Cap:AUTOREPORT_TEMP:1") == Capability{"AUTOREPORT_TEMP", true});
  CHECK(read<FirmwareName>("FIRMWARE_NAME:Marlin 2.1.2 (x) SOURCE_CODE_URL:y").name ==
        "Marlin 2.1.2 (x)");
  (void)read<Unknown>("Q\xffJok");
  (void)read<Unknown>("okay");
  (void)read<Unknown>("");
}

TEST_CASE("Any bytes are some reply") {
  Rng rng(7);
  const std::string_view seed_text = "ok N4 P13 B3 T:21.9 /0.0 Resend: Last Line: Error:echo:busy:";
  for (int round = 0; round < 20'000; ++round) {
    std::string line(seed_text.substr(rng.below(seed_text.size()), rng.below(20)));
    line += static_cast<char>(rng.below(256));
    line += seed_text.substr(rng.below(seed_text.size()), rng.below(30));
    (void)parse_reply(line);
  }
  SUCCEED("no crash");
}

}  // namespace
}  // namespace slipstick
