#include "drivers/marlin/reply.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace slipstick {
namespace {

/// Texts after which Marlin 1.0 to 2.1 says nothing more until it is reset, or goes on
/// acknowledging moves and makes none (temperature.cpp, MarlinCore.cpp, language.h).
constexpr std::array<std::string_view, 13> kFatalTexts{
    "kill()",           "system stopped!",     "Printer halted",
    "Thermal Runaway",  "MAXTEMP triggered",   "MINTEMP triggered",
    "Heating failed",   "Thermal Malfunction", "!! KILL caused",
    "!! STOP called",   "Printer stopped",     "Heater switched off",
    "Watchdog timeout",
};

constexpr std::string_view kFirmwareName = "FIRMWARE_NAME:";

/// What Marlin says of its reset, behind `start`; the first blank of some is not there any more.
constexpr std::array<std::string_view, 5> kResetCauses{
    "PowerUp", "External Reset", "Brown out Reset", "Watchdog Reset", "Software Reset"};

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool starts_with_any_case(std::string_view text, std::string_view prefix) {
  return text.size() >= prefix.size() &&
         std::ranges::equal(text.substr(0, prefix.size()), prefix, {}, lower, lower);
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// The number at the front of `text` behind blanks, `:` and `N`.
template <typename Integer>
std::optional<Integer> leading_number(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" :N");
  if (at == std::string_view::npos) return std::nullopt;
  Integer value{};
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  return value;
}

template <typename Integer>
std::optional<Integer> number_behind(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  return leading_number<Integer>(text.substr(at + key.size()));
}

/// \pre `text` begins with `ok`.
Ok parse_ok(std::string_view text) {
  const std::string_view rest = trimmed(text.substr(2));
  Ok ok;
  ok.bare = rest.empty();
  ok.temperatures = parse_temperatures(rest);
  if (ok.temperatures) return ok;
  if (rest.starts_with('N')) ok.line = leading_number<LineNumber>(rest);
  ok.free_moves = number_behind<int>(text, " P");
  ok.free_commands = number_behind<int>(text, " B");
  return ok;
}

bool is_ok(std::string_view text) {
  return text == "ok" || text.starts_with("ok ") || text.starts_with("ok\t");
}

bool is_fatal(std::string_view text) {
  return std::ranges::any_of(kFatalTexts, [&](auto fatal) { return contains(text, fatal); });
}

Reply parse_error(std::string_view text) {
  const std::string said(trimmed(text));
  if (is_fatal(said)) return Fatal{said};
  return ErrorText{said};
}

/// "Marlin 2.1.2", with or without `echo:`.
bool is_version(std::string_view text) {
  constexpr std::string_view kName = "Marlin ";
  return text.size() > kName.size() && text.starts_with(kName) && text[kName.size()] >= '0' &&
         text[kName.size()] <= '9';
}

/// A line of the banner.
std::optional<Start> parse_start(std::string_view text) {
  if (text == "start" || is_version(text)) return Start{};
  if (text.starts_with("echo:") && is_version(text.substr(5))) return Start{};
  if (std::ranges::find(kResetCauses, text) == kResetCauses.end()) return std::nullopt;
  return Start{std::string(text)};
}

/// Whether it is said without `Error:`: the second line of what Marlin 1.0 says of a heater, what
/// Marlin 2 says of each move once it has stopped, and Repetier's prefix.
bool is_fatal_alone(std::string_view text) {
  if (text.starts_with("!!") || text.starts_with("fatal:")) return true;
  return (text.starts_with(": ") || text.starts_with("Printer stopped")) && is_fatal(text);
}

Reply parse_echo(std::string_view text) {
  const std::string said(trimmed(text));
  if (said.starts_with("busy:")) return Busy{std::string(trimmed(text.substr(5)))};
  if (said.starts_with("Unknown command:")) return UnknownCommand{said};
  return Echo{said};
}

Reply parse_firmware(std::string_view text) {
  std::string_view name = text.substr(text.find(kFirmwareName) + kFirmwareName.size());
  name = name.substr(0, name.find(" SOURCE_CODE_URL:"));
  return FirmwareName{std::string(trimmed(name))};
}

Reply parse_capability(std::string_view text) {
  const std::string_view rest = text.substr(std::string_view("Cap:").size());
  const std::size_t colon = rest.find(':');
  if (colon == std::string_view::npos) return Unknown{std::string(text)};
  return Capability{std::string(rest.substr(0, colon)), rest.substr(colon + 1) == "1"};
}

Reply parse_comment(std::string_view text) {
  const std::string_view said = trimmed(text.substr(2));
  constexpr std::string_view kAction = "action:";
  if (!said.starts_with(kAction)) return Echo{std::string(said)};
  return Action{std::string(trimmed(said.substr(kAction.size())))};
}

}  // namespace

Reply parse_reply(std::string_view line) {
  const std::string_view text = trimmed(line);
  // Klipper puts it behind its ok.
  const bool names =
      text.starts_with(kFirmwareName) || (is_ok(text) && contains(text, kFirmwareName));
  if (names) return parse_firmware(text);
  if (is_ok(text)) return parse_ok(text);
  if (starts_with_any_case(text, "resend"))
    return Resend{leading_number<LineNumber>(text.substr(6))};
  if (starts_with_any_case(text, "rs ")) return Resend{leading_number<LineNumber>(text.substr(3))};
  // Looked for anywhere: the number matters even when the words before it were damaged.
  if (contains(text, "Last Line: ")) {
    return LineError{number_behind<LineNumber>(text, "Last Line:"), std::string(text)};
  }
  if (starts_with_any_case(text, "error:")) return parse_error(text.substr(6));
  if (is_fatal_alone(text)) return Fatal{std::string(text)};
  if (auto start = parse_start(text)) return *std::move(start);
  if (text.starts_with("echo:")) return parse_echo(text.substr(5));
  if (text.starts_with("busy:")) return parse_echo(text);
  if (text.starts_with("//")) return parse_comment(text);
  if (text.starts_with("Cap:")) return parse_capability(text);
  if (text == "wait") return Wait{};
  if (const auto position = parse_position(text)) return PositionReport{*position};
  if (auto temperatures = parse_temperatures(text)) return *std::move(temperatures);
  return Unknown{std::string(text)};
}

}  // namespace slipstick
