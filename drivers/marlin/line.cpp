#include "drivers/marlin/line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "drivers/marlin/job_rules.h"

namespace slipstick {
namespace {

constexpr std::string_view kRefused = "*;\\\"()";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool may_stand(char c) {
  return c >= ' ' && c <= '~' && kRefused.find(c) == std::string_view::npos;
}

std::string without_comments(std::string_view raw) {
  std::string kept;
  bool in_brackets = false;
  for (const char c : raw.substr(0, raw.find(';'))) {
    if (c == '(') in_brackets = true;
    if (!in_brackets) kept += c;
    if (c == ')') in_brackets = false;
  }
  return kept;
}

std::string with_single_blanks(std::string_view text) {
  std::string kept;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!blank) kept += c;
    if (blank && !kept.empty() && kept.back() != ' ') kept += ' ';
  }
  if (!kept.empty() && kept.back() == ' ') kept.pop_back();
  return kept;
}

/// Drops `N12 ` and `*99`, however often they are there.
std::string_view without_framing(std::string_view text) {
  while (text.size() >= 2 && text[0] == 'N' && is_digit(text[1])) {
    text.remove_prefix(1);
    while (!text.empty() && (is_digit(text.front()) || text.front() == ' ')) text.remove_prefix(1);
    text = text.substr(0, text.rfind('*'));
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  }
  return text;
}

bool may_stand_in_number(char c) {
  return is_digit(c) || c == '.' || c == '-' || c == '+';
}

/// `number` with at most five decimals: Marlin's floats tell no more of 100 mm.
std::string rounded(std::string_view number) {
  constexpr std::size_t kDecimals = 5;
  constexpr double kLargest = 1e9;
  const std::size_t point = number.find('.');
  const bool is_long = point != number.npos && number.size() - point > kDecimals + 1;
  const auto value = is_long ? parse_number(number) : std::nullopt;
  if (!value || std::abs(*value) >= kLargest) return std::string(number);
  std::string text;
  append_rounded(text, *value, int{kDecimals});
  return text;
}

std::string with_rounded_numbers(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const auto* end = std::ranges::find_if_not(text, may_stand_in_number);
    const auto size = static_cast<std::size_t>(end - text.begin());
    kept += size > 0 ? rounded(text.substr(0, size)) : std::string(1, text.front());
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return kept;
}

/// Says the same in fewer bytes, as far as that is possible.
std::string shortened(std::string_view text) {
  if (text.front() == 'G') return with_rounded_numbers(text);
  if (!is_message(text)) return std::string(text);
  text = text.substr(0, Line::kMaxText);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return std::string(text);
}

tl::unexpected<Error> refused(std::string_view text, std::string_view why) {
  return fail(ErrorCode::kInput, fmt::format("G-code line '{}': {}", text.substr(0, 40), why));
}

}  // namespace

Result<Line> Line::make(std::string_view text) {
  if (text.empty()) return refused(text, "it is empty");
  const auto* bad = std::ranges::find_if_not(text, may_stand);
  if (bad != text.end()) {
    return refused(text, fmt::format("byte 0x{:02x} at column {} cannot be sent to a printer",
                                     static_cast<unsigned char>(*bad), bad - text.begin() + 1));
  }
  if (text.front() == ' ' || text.back() == ' ') return refused(text, "a blank at an end");
  if (text.size() > kMaxText) {
    return refused(text, fmt::format("{} bytes; firmware keeps {}", text.size(), kMaxText));
  }
  if (text.find("M110") != std::string_view::npos) {
    return refused(text, "M110 anywhere in a line breaks line numbering; remove it");
  }
  return Line(text);
}

Result<std::optional<Line>> normalise(std::string_view raw) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (raw.starts_with(kByteOrderMark)) raw.remove_prefix(kByteOrderMark.size());
  const std::string clean = with_single_blanks(without_comments(raw));
  const std::string_view text = without_framing(clean);
  if (text.empty()) return std::optional<Line>();
  if (const auto why = unfit_for_job(text); !why.empty()) return refused(text, why);
  if (text.front() == '@') return std::optional<Line>();  // words to some host
  std::string kept =
      is_message(text) ? with_single_blanks(sendable_message(text)) : std::string(text);
  if (kept.size() > Line::kMaxText) kept = shortened(kept);
  return Line::make(kept).map([](Line&& line) { return std::optional<Line>(std::move(line)); });
}

bool is_command(std::string_view text, std::string_view code) {
  if (!text.starts_with(code)) return false;
  return text.size() == code.size() || (!is_digit(text[code.size()]) && text[code.size()] != '.');
}

}  // namespace slipstick
