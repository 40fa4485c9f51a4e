#include "sim/personality.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "sim/reports.h"

namespace slipstick {

namespace {

constexpr std::string_view kBusy = "echo:busy: processing\n";
constexpr std::string_view kKilled = "Error:Printer halted. kill() called!\n";
constexpr std::string_view kShutdown = "echo:M112 Shutdown\n";

constexpr std::string_view kGreeting212 =
    "start\n"
    "PowerUp\n"
    "Marlin 2.1.2\n"
    "echo: Last Updated: 2022-12-17 | Author: (none, default config)\n"
    "echo: Compiled: Nov 22 2026\n"
    "echo: Free Memory: 0  PlannerBufferBytes: 1280\n"
    "echo:Hardcoded Default Settings Loaded\n";
constexpr std::string_view kIdentity212 =
    "FIRMWARE_NAME:Marlin 2.1.2 (Nov 22 2026 21:24:11) "
    "SOURCE_CODE_URL:github.com/MarlinFirmware/Marlin PROTOCOL_VERSION:1.0 "
    "MACHINE_TYPE:SimRap 1.4 EXTRUDER_COUNT:1 UUID:cede2a2f-41a2-4748-9b12-c55c62f367ff\n";

constexpr std::string_view kCapabilities11 =
    "SERIAL_XON_XOFF:0 EEPROM:0 VOLUMETRIC:1 AUTOREPORT_TEMP:1 PROGRESS:0 PRINT_JOB:1 "
    "AUTOLEVEL:0 Z_PROBE:0 LEVELING_DATA:0 BUILD_PERCENT:0 SOFTWARE_POWER:0 "
    "TOGGLE_LIGHTS:0 CASE_LIGHT_BRIGHTNESS:0 EMERGENCY_PARSER:0 AUTOREPORT_SD_STATUS:0 "
    "THERMAL_PROTECTION:1";
constexpr std::string_view kCapabilities20 =
    "SERIAL_XON_XOFF:0 BINARY_FILE_TRANSFER:0 EEPROM:0 VOLUMETRIC:1 AUTOREPORT_TEMP:1 "
    "PROGRESS:0 PRINT_JOB:1 AUTOLEVEL:0 RUNOUT:0 Z_PROBE:0 LEVELING_DATA:0 "
    "BUILD_PERCENT:0 SOFTWARE_POWER:0 TOGGLE_LIGHTS:0 CASE_LIGHT_BRIGHTNESS:0 "
    "EMERGENCY_PARSER:0 PROMPT_SUPPORT:0 SDCARD:0 AUTOREPORT_SD_STATUS:0 LONG_FILENAME:0 "
    "THERMAL_PROTECTION:1 MOTION_MODES:0 ARCS:1 BABYSTEPPING:0 CHAMBER_TEMPERATURE:0";
constexpr std::string_view kCapabilities21 =
    "SERIAL_XON_XOFF:0 BINARY_FILE_TRANSFER:0 EEPROM:0 VOLUMETRIC:1 AUTOREPORT_POS:0 "
    "AUTOREPORT_TEMP:1 PROGRESS:0 PRINT_JOB:1 AUTOLEVEL:0 RUNOUT:0 Z_PROBE:0 "
    "LEVELING_DATA:0 BUILD_PERCENT:0 SOFTWARE_POWER:0 TOGGLE_LIGHTS:0 "
    "CASE_LIGHT_BRIGHTNESS:0 EMERGENCY_PARSER:0 HOST_ACTION_COMMANDS:0 PROMPT_SUPPORT:0 "
    "SDCARD:0 REPEAT:0 SD_WRITE:0 AUTOREPORT_SD_STATUS:0 LONG_FILENAME:0 LFN_WRITE:0 "
    "CUSTOM_FIRMWARE_UPLOAD:0 EXTENDED_M20:0 THERMAL_PROTECTION:1 MOTION_MODES:0 ARCS:1 "
    "BABYSTEPPING:0 CHAMBER_TEMPERATURE:0 COOLER_TEMPERATURE:0 MEATPACK:0 "
    "CONFIG_EXPORT:0";

constexpr std::array kPersonalities = std::to_array<Personality>({
    {.name = "marlin-1.0.2",
     .greeting = "start\necho:Marlin 1.0.2\necho: Free Memory: 4096  PlannerBufferBytes: 1232\n",
     .greets_with_settings = false,
     .identity = "FIRMWARE_NAME:Marlin 1.0.2 "
                 "PROTOCOL_VERSION:1.0 MACHINE_TYPE:SimRap EXTRUDER_COUNT:1\n",
     .capabilities = "",
     .lines = {.numbers = NumberCheck::kAnyN,
               .duplicates = Duplicates::kError,
               .first_star = true,
               .star_needs_number = true},
     .complaint = Complaint::kMarlin,
     .resend = "Resend: ",
     .resend_tail = "ok\n",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kExact,
     .busy = "",
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = kKilled,
     .queue_max = 4,
     .line_max = 95},
    {.name = "marlin-1.1.9",
     .greeting = "start\necho:Marlin 1.1.9\necho: Free Memory: 4096  PlannerBufferBytes: 1280\n",
     .greets_with_settings = true,
     .identity = "FIRMWARE_NAME:Marlin 1.1.9 "
                 "SOURCE_CODE_URL:github.com/MarlinFirmware/Marlin PROTOCOL_VERSION:1.0 "
                 "MACHINE_TYPE:SimRap EXTRUDER_COUNT:1\n",
     .capabilities = kCapabilities11,
     .lines = {.duplicates = Duplicates::kError},
     .complaint = Complaint::kMarlin,
     .resend = "Resend: ",
     .resend_tail = "ok\n",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kExact,
     .busy = kBusy,
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = kKilled,
     .queue_max = 4,
     .line_max = 95},
    {.name = "marlin-2.0.7",
     .greeting = "start\necho:Marlin 2.0.7\necho: Free Memory: 4096  PlannerBufferBytes: 1280\n",
     .greets_with_settings = true,
     .identity = "FIRMWARE_NAME:Marlin 2.0.7 "
                 "SOURCE_CODE_URL:github.com/MarlinFirmware/Marlin PROTOCOL_VERSION:1.0 "
                 "MACHINE_TYPE:SimRap EXTRUDER_COUNT:1\n",
     .capabilities = kCapabilities20,
     .lines = {.duplicates = Duplicates::kError},
     .complaint = Complaint::kMarlin,
     .resend = "Resend: ",
     .resend_tail = "ok\n",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kPrefix,
     .busy = kBusy,
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = kKilled,
     .queue_max = 4,
     .line_max = 95},
    {.name = "marlin-2.0.8",
     .greeting = "start\necho:Marlin 2.0.8\necho: Free Memory: 4096  PlannerBufferBytes: 1280\n",
     .greets_with_settings = true,
     .identity = "FIRMWARE_NAME:Marlin 2.0.8 "
                 "SOURCE_CODE_URL:github.com/MarlinFirmware/Marlin PROTOCOL_VERSION:1.0 "
                 "MACHINE_TYPE:SimRap EXTRUDER_COUNT:1\n",
     .capabilities = kCapabilities20,
     .lines = {.duplicates = Duplicates::kError},
     .complaint = Complaint::kMarlin,
     .resend = "Resend: ",
     .resend_tail = "",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kPrefix,
     .busy = kBusy,
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = kKilled,
     .queue_max = 4,
     .line_max = 95},
    {.name = "marlin-2.0.9",
     .greeting = "start\necho:Marlin 2.0.9\necho: Free Memory: 4096  PlannerBufferBytes: 1280\n",
     .greets_with_settings = true,
     .identity = "FIRMWARE_NAME:Marlin 2.0.9 "
                 "SOURCE_CODE_URL:github.com/MarlinFirmware/Marlin PROTOCOL_VERSION:1.0 "
                 "MACHINE_TYPE:SimRap EXTRUDER_COUNT:1\n",
     .capabilities = kCapabilities20,
     .lines = {.duplicates = Duplicates::kError},
     .complaint = Complaint::kMarlin,
     .resend = "Resend: ",
     .resend_tail = "ok\n",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kPrefix,
     .busy = kBusy,
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = kKilled,
     .queue_max = 4,
     .line_max = 95},
    {.name = "marlin-2.1.2",
     .greeting = kGreeting212,
     .greets_with_settings = true,
     .identity = kIdentity212,
     .capabilities = kCapabilities21,
     .lines = {},
     .complaint = Complaint::kMarlin,
     .resend = "Resend: ",
     .resend_tail = "ok\n",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kPrefix,
     .busy = kBusy,
     .wait_period = Moment(0),
     .shutdown = kShutdown,
     .killed = kKilled,
     .queue_max = 4,
     .line_max = 95},
    {.name = "prusa-mk3",
     .greeting = "start\necho: 3.14.0\n",
     .greets_with_settings = false,
     .identity = "FIRMWARE_NAME:Prusa-Firmware 3.14.0 based on Marlin "
                 "FIRMWARE_URL:https://github.com/prusa3d/Prusa-Firmware PROTOCOL_VERSION:1.0 "
                 "MACHINE_TYPE:Prusa i3 MK3S EXTRUDER_COUNT:1\n",
     .capabilities = "AUTOREPORT_TEMP:1 AUTOREPORT_FANS:0 AUTOREPORT_POSITION:0 EXTENDED_M20:0 "
                     "PRUSA_MMU2:0",
     .lines = {.duplicates = Duplicates::kError, .first_star = true, .star_needs_number = true},
     .complaint = Complaint::kMarlin,
     .resend = "Resend: ",
     .resend_tail = "ok\n",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kBare,
     .busy = kBusy,
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = kKilled,
     .queue_max = 4,
     .line_max = 95},
    {.name = "creality",
     .greeting = "start\n",
     .greets_with_settings = false,
     .identity = "FIRMWARE_NAME:Marlin Ver 1.0.1 "
                 "PROTOCOL_VERSION:1.0 MACHINE_TYPE:Ender-3 EXTRUDER_COUNT:1\n",
     .capabilities = "",
     .lines = {.duplicates = Duplicates::kError},
     .complaint = Complaint::kMarlin,
     .resend = "Resend: ",
     .resend_tail = "ok\n",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kExact,
     .busy = kBusy,
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = kKilled,
     .queue_max = 4,
     .line_max = 95},
    {.name = "repetier",
     .greeting = "start\n",
     .greets_with_settings = false,
     .identity = "FIRMWARE_NAME:Repetier_1.0.4 PROTOCOL_VERSION:1.0 EXTRUDER_COUNT:1\n",
     .capabilities = "",
     .lines = {.duplicates = Duplicates::kSkipLastForty},
     .complaint = Complaint::kRepetier,
     .resend = "\nResend:",
     .resend_tail = "ok\n",
     .ok = OkTime::kWhenReceived,
     .early = EarlyStop::kBare,
     .busy = "busy:processing\n",
     .wait_period = Moment(1'000'000),
     .shutdown = "",
     .killed = "fatal:emergency stop\n",
     .queue_max = 2,
     .line_max = 95},
    {.name = "reprapfirmware",
     .greeting = "",
     .greets_with_settings = false,
     .identity =
         "FIRMWARE_NAME: RepRapFirmware for Duet 2 FIRMWARE_VERSION: 3.5 ELECTRONICS: Duet 2\n",
     .capabilities = "",
     .lines = {.numbers = NumberCheck::kChecksumOnly},
     .complaint = Complaint::kNone,
     .resend = "",
     .resend_tail = "",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kBare,
     .busy = "",
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = "Error: emergency stop\n",
     .queue_max = 1,
     .line_max = 255},
    {.name = "smoothieware",
     .greeting = "Smoothie\nok\n",
     .greets_with_settings = false,
     .identity = "FIRMWARE_NAME:Smoothieware, FIRMWARE_URL:http%3A//smoothieware.org, "
                 "PROTOCOL_VERSION:1.0\n",
     .capabilities = "",
     .lines = {.duplicates = Duplicates::kError},
     .complaint = Complaint::kNone,
     .resend = "rs N",
     .resend_tail = "",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kBare,
     .busy = "",
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = "ok Emergency Stop Requested\n",
     .queue_max = 4,
     .line_max = 95},
    {.name = "klipper",
     .greeting = "",
     .greets_with_settings = false,
     .identity = "ok FIRMWARE_VERSION:v0.12 FIRMWARE_NAME:Klipper\n",
     .capabilities = "",
     .lines = {.numbers = NumberCheck::kNone},
     .complaint = Complaint::kNone,
     .resend = "",
     .resend_tail = "",
     .ok = OkTime::kWhenDone,
     .early = EarlyStop::kExact,
     .busy = "",
     .wait_period = Moment(0),
     .shutdown = "",
     .killed = "!! Shutdown due to M112 command\n",
     .queue_max = 20,
     .line_max = 4095},
});

constexpr std::string_view kPowerUp = "PowerUp\n";

std::string_view cause_line(ResetCause cause) {
  switch (cause) {
    case ResetCause::kButton:
      return " External Reset\n";
    case ResetCause::kBrownOut:
      return " Brown out Reset\n";
    case ResetCause::kWatchdog:
      return " Watchdog Reset\n";
    case ResetCause::kPowerUp:
    case ResetCause::kUnheard:
      break;
  }
  return kPowerUp;
}

}  // namespace

const Personality& default_personality() {
  const auto* found = std::ranges::find(kPersonalities, "marlin-2.1.2", &Personality::name);
  SLIPSTICK_CHECK(found != kPersonalities.end());
  return *found;
}

std::optional<Personality> find_personality(std::string_view name) {
  const auto* found = std::ranges::find(kPersonalities, name, &Personality::name);
  if (found == kPersonalities.end()) return std::nullopt;
  return *found;
}

std::string personality_names() {
  std::string names;
  for (const Personality& p : kPersonalities) {
    names.append(names.empty() ? "" : ", ").append(p.name);
  }
  return names;
}

std::string banner_report(const Personality& personality, const Machine& machine,
                          ResetCause cause) {
  if (cause == ResetCause::kUnheard) return {};
  std::string text(personality.greeting);
  if (const std::size_t at = text.find(kPowerUp); at != std::string::npos) {
    text.replace(at, kPowerUp.size(), cause_line(cause));
  }
  if (personality.greets_with_settings) text += settings_report(machine);
  return text;
}

std::string identity_report(const Personality& personality, const Features& features) {
  std::string text(personality.identity);
  std::string_view rest = personality.capabilities;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    text += fmt::format("Cap:{}\n", capability_with(features, rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return text;
}

}  // namespace slipstick
