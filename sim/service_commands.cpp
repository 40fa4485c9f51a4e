#include "sim/service_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "sim/reports.h"

namespace slipstick {

namespace {

constexpr std::string_view kDefaultsLoaded = "echo:Hardcoded Default Settings Loaded\n";

/// The names of the bits of M111 S. None of them is obeyed.
std::string debug_report(unsigned bits) {
  constexpr std::array<std::string_view, 5> kNames{"ECHO", "INFO", "ERRORS", "DRYRUN",
                                                   "COMMUNICATION"};
  std::string names;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if ((bits >> i & 1U) == 0) continue;
    names.append(names.empty() ? "" : ",").append(kNames[i]);
  }
  return fmt::format("echo:DEBUG:{}\n", names.empty() ? "off" : names);
}

std::string run_endstops(const GcodeCommand& command, Machine& machine) {
  if (const auto on = command.value('S')) {
    machine.soft_endstops = *on != 0;
    return {};
  }
  const auto [least, most] = machine.options.kinematics.reach(machine.options.build_volume);
  return fmt::format(
      "  M211 S{}\n  Min:  X{:.2f} Y{:.2f} Z{:.2f}   Max:  X{:.2f} Y{:.2f} Z{:.2f}\n",
      machine.soft_endstops ? "1 ; ON" : "0 ; OFF", least.x, least.y, least.z, most.x, most.y,
      most.z);
}

std::string run_filament_sensor(const GcodeCommand& command, Machine& machine) {
  const auto on = command.value('S');
  const auto host = command.value('H');
  if (on) machine.watches_filament = *on != 0;
  if (host) machine.host_handles_runout = *host != 0;
  if (on || host || command.has('R')) return {};
  const auto word = [](bool yes) { return yes ? "ON" : "OFF"; };
  std::string text = fmt::format("echo:Filament runout {}", word(machine.watches_filament));
  if (machine.options.features.has(Feature::kHostPrompts)) {
    text += fmt::format(" ; Host handling {}", word(machine.host_handles_runout));
  }
  return text + "\n";
}

/// There is nothing to load but what the firmware was built with.
std::string load_defaults(Machine& machine) {
  machine.limits = machine.options.limits;
  return std::string(kDefaultsLoaded);
}

/// "(812 bytes; crc 12345)": Marlin's own CRC of what is stored.
std::string size_and_crc(const Machine& machine) {
  constexpr std::uint16_t kPolynomial = 0x1021;
  const std::string text = settings_report(machine);
  std::uint16_t crc = 0;
  for (const char c : text) {
    crc = static_cast<std::uint16_t>(crc ^ static_cast<unsigned char>(c) << 8U);
    for (int bit = 0; bit < 8; ++bit) {
      const bool carries = (crc & 0x8000U) != 0;
      crc = static_cast<std::uint16_t>(crc << 1U);
      if (carries) crc ^= kPolynomial;
    }
  }
  return fmt::format("({} bytes; crc {})\n", text.size(), crc);
}

std::string store(Machine& machine) {
  machine.stored = machine.limits;
  return "echo:Settings Stored " + size_and_crc(machine);
}

std::string load_stored(Machine& machine) {
  if (!machine.stored) return load_defaults(machine);
  machine.limits = *machine.stored;
  return "echo:V86 stored settings retrieved " + size_and_crc(machine);
}

}  // namespace

std::optional<std::string> run_service_command(const GcodeCommand& command, Machine& machine,
                                               Moment now) {
  if (command.letter() != 'M') return std::nullopt;
  const auto has = [&](Feature feature) { return machine.options.features.has(feature); };
  if (has(Feature::kSdCard)) {
    if (auto answer = machine.card.run(command)) return answer;
  }
  switch (command.code()) {
    case 111:
      return debug_report(
          static_cast<unsigned>(std::clamp(command.value('S').value_or(0), 0.0, 255.0)));
    case 119:
      return "Reporting endstop status\nx_min: open\ny_min: open\nz_min: open\n";
    case 211:
      return run_endstops(command, machine);
    case 31:
      return "echo:Print time: " + machine.job.text(now) + "\n";
    case 73:
      if (!has(Feature::kProgress)) return std::nullopt;
      return "";
    case 75:
      machine.job.start(now);
      return "";
    case 76:
      machine.job.pause(now);
      return "";
    case 77:
      machine.job.stop(now);
      return "";
    case 412:
      if (!has(Feature::kFilamentSensor)) return std::nullopt;
      return run_filament_sensor(command, machine);
    case 420:
      if (!has(Feature::kBedLeveling)) return std::nullopt;
      return machine.leveling.run(command);
    case 500:
      return has(Feature::kEeprom) ? store(machine) : "Error:EEPROM disabled\n";
    case 501:
      return load_stored(machine).append(settings_report(machine));
    case 502:
      return load_defaults(machine);
    case 503:
      return settings_report(machine);
    default:
      return std::nullopt;
  }
}

}  // namespace slipstick
