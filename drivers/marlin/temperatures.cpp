#include "drivers/marlin/temperatures.h"

#include <limits>

#include "core/base/number_text.h"

namespace slipstick {
namespace {

std::string_view skip_blanks(std::string_view text) {
  const std::size_t at = text.find_first_not_of(' ');
  return at == std::string_view::npos ? std::string_view() : text.substr(at);
}

std::string_view take_word(std::string_view& text) {
  text = skip_blanks(text);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

std::optional<double> degrees(std::string_view text) {
  if (text == "nan" || text == "-nan" || text == "inf" || text == "-inf") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return parse_number(text);
}

/// Reads `21.87` and, when it follows, ` /0.00`, which is taken off `rest`.
std::optional<HeaterReading> read_heater(std::string_view value, std::string_view& rest) {
  HeaterReading heater;
  const std::size_t slash = value.find('/');
  const auto celsius = degrees(value.substr(0, slash));
  if (slash != std::string_view::npos) heater.target = degrees(value.substr(slash + 1));
  if (const auto next = skip_blanks(rest); next.starts_with('/')) {
    heater.target = degrees(take_word(rest).substr(1));
  }
  if (!celsius) return std::nullopt;
  heater.celsius = *celsius;
  return heater;
}

bool is_tool(std::string_view key) {
  return key.size() == 2 && key[0] == 'T' && key[1] >= '0' && key[1] <= '9';
}

void store(Temperatures& report, std::string_view key, const HeaterReading& heater) {
  if (key == "T") report.hotend = heater;
  if (key == "B") report.bed = heater;
  if (key == "C") report.chamber = heater;
  if (is_tool(key) && report.tools.size() < Temperatures::kMaxTools) report.tools.push_back(heater);
}

}  // namespace

std::optional<Temperatures> parse_temperatures(std::string_view text) {
  text = skip_blanks(text);
  const std::string_view first = text.substr(0, text.find(':'));
  if (first.size() == text.size() || (first != "T" && first != "B" && !is_tool(first))) {
    return std::nullopt;
  }
  Temperatures report;
  while (!text.empty()) {
    const std::string_view word = take_word(text);
    const std::size_t colon = word.find(':');
    if (colon == std::string_view::npos) continue;
    if (word.starts_with("W:")) report.waiting = true;
    if (const auto heater = read_heater(word.substr(colon + 1), text)) {
      store(report, word.substr(0, colon), *heater);
    }
  }
  // Klipper names the only tool there is.
  if (!report.hotend && report.tools.size() == 1) report.hotend = report.tools.front();
  return report;
}

}  // namespace slipstick
