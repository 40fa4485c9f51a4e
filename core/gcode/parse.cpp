#include "core/gcode/parse.h"

#include <charconv>

namespace slipstick {

namespace {

constexpr int kCodeMax = 1'000'000'000;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_name(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_numeral(char c) {
  return is_digit(c) || c == '.' || c == '-' || c == '+';
}

std::string_view without_leading_blanks(std::string_view text) {
  const std::size_t start = text.find_first_not_of(' ');
  return start == std::string_view::npos ? std::string_view() : text.substr(start);
}

std::string_view without_trailing_blanks(std::string_view text) {
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

std::string_view without_line_number(std::string_view text) {
  if (text.size() < 2 || text[0] != 'N' || !(is_digit(text[1]) || text[1] == '-')) return text;
  std::size_t end = 2;
  while (end < text.size() && is_digit(text[end])) ++end;
  return without_leading_blanks(text.substr(end));
}

/// The number that `text` begins with; nothing where it does not.
std::optional<double> leading_number(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  double value = 0;
  const auto read =
      std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  const bool number = read.ec == std::errc() && is_numeral(*(read.ptr - 1));  // Not "inf".
  return number ? std::optional(value) : std::nullopt;
}

}  // namespace

GcodeCommand::GcodeCommand(char letter, int code, std::string_view text)
    : letter_(letter), code_(code), text_(text) {
  read_words(text);
}

void GcodeCommand::read_words(std::string_view words) {
  std::size_t i = 0;
  const auto skip_blanks = [&] {
    while (i < words.size() && words[i] == ' ') ++i;
  };
  while (i < words.size()) {
    const char name = words[i++];
    if (is_name(name)) {
      skip_blanks();
      seen_ |= bit(name);
      valued_ &= ~bit(name);
      if (const auto value = leading_number(words.substr(i))) {
        valued_ |= bit(name);
        values_[static_cast<std::size_t>(name - 'A')] = *value;
      }
    }
    while (i < words.size() && is_numeral(words[i])) ++i;
    skip_blanks();
  }
}

std::string_view bare_command(std::string_view line) {
  line = line.substr(0, line.find(';'));
  line = without_line_number(without_leading_blanks(line));
  return without_trailing_blanks(line.substr(0, line.find('*')));
}

std::optional<GcodeCommand> parse_gcode(std::string_view line) {
  line = bare_command(line);
  if (line.empty()) return std::nullopt;
  const char letter = line[0];
  if (letter != 'G' && letter != 'M' && letter != 'T') return std::nullopt;
  line = without_leading_blanks(line.substr(1));
  if (line.empty() || !is_digit(line[0])) return std::nullopt;

  std::size_t end = 0;
  int code = 0;
  while (end < line.size() && is_digit(line[end])) {
    if (code < kCodeMax / 10) code = code * 10 + (line[end] - '0');
    ++end;
  }
  if (end < line.size() && line[end] == '.') {
    ++end;
    while (end < line.size() && is_digit(line[end])) ++end;
  }
  return GcodeCommand(letter, code, without_leading_blanks(line.substr(end)));
}

}  // namespace slipstick
