#include "drivers/marlin/job_rules.h"

#include <algorithm>
#include <array>

#include "core/gcode/parse.h"

namespace slipstick {
namespace {

constexpr std::array kCardM{23, 24, 26, 28, 29, 30, 32, 928};
constexpr std::array kEndingM{112, 410, 997};
constexpr std::array kMessageM{0, 1, 117, 118, 486};
constexpr std::array<std::string_view, 4> kHostWords{"@pause", "@cancel", "@abort", "@kill"};
constexpr std::string_view kDropped = "*\"\\";

template <std::size_t size>
bool is_one_of(const std::array<int, size>& codes, std::string_view text) {
  if (!text.starts_with('M')) return false;  // most lines are moves
  const auto command = parse_gcode(text);
  return command && command->letter() == 'M' && std::ranges::binary_search(codes, command->code());
}

bool is_host_word(std::string_view text) {
  return std::ranges::find(kHostWords, text.substr(0, text.find(' '))) != kHostWords.end();
}

}  // namespace

std::string_view unfit_for_job(std::string_view text) {
  if (is_one_of(kCardM, text)) return "it is about a print from the printer's own card; remove it";
  if (is_one_of(kEndingM, text)) return "it stops the printer; remove it";
  if (is_host_word(text) || is_one_of(std::array{25}, text)) {
    return "nothing here heeds it; M0 or M600 lets the printer wait for you";
  }
  return {};
}

bool is_message(std::string_view text) {
  return is_one_of(kMessageM, text);
}

std::string sendable_message(std::string_view text) {
  std::string kept;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    constexpr unsigned char kFirstOfLetter = 0xc0;  // UTF-8: below it, the rest of a letter
    if (byte >= kFirstOfLetter) kept += '?';
    if (byte >= ' ' && byte <= '~' && kDropped.find(c) == kDropped.npos) kept += c;
    if (kept.ends_with("M110")) kept.insert(kept.size() - 3, " ");
  }
  while (kept.ends_with(' ')) kept.pop_back();
  return kept;
}

}  // namespace slipstick
