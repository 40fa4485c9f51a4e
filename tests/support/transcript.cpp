// The written form of a dialogue -> its lines.
#include "tests/support/transcript.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace slipstick::test {
namespace {

constexpr std::string_view kControl = "control: ";

std::optional<char> hex_byte(std::string_view digits) {
  unsigned value = 0;
  if (digits.size() < 2) return std::nullopt;
  const auto read = std::from_chars(digits.data(), digits.data() + 2, value, 16);
  if (read.ptr != digits.data() + 2) return std::nullopt;
  return static_cast<char>(value);
}

std::string unescaped(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = text[i] == '\\' && i + 1 < text.size() ? text[i + 1] : '\0';
    const auto hex = next == 'x' ? hex_byte(text.substr(i + 2)) : std::nullopt;
    if (hex) {
      bytes += *hex;
      i += 3;
    } else if (next == 'n' || next == 'r' || next == '\\') {
      bytes += next == 'n' ? '\n' : next == 'r' ? '\r' : '\\';
      ++i;
    } else {
      bytes += text[i];
    }
  }
  return bytes;
}

std::string_view without_blanks_before(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text;
}

std::optional<Moment> take_time(std::string_view& text) {
  double seconds = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (read.ec != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  return Moment(std::llround(seconds * 1e6));
}

std::optional<TranscriptLine> read_line(std::string_view line, int number) {
  using Kind = TranscriptLine::Kind;
  TranscriptLine read;
  read.number = number;
  line = without_blanks_before(line);
  read.at = take_time(line);
  line = without_blanks_before(line);
  if (line.empty()) return std::nullopt;
  const char mark = line[0];
  line.remove_prefix(line.size() > 1 && line[1] == mark ? 2 : 1);
  if (line.starts_with(' ')) line.remove_prefix(1);
  if (mark == '#' || mark == '!') {
    const std::size_t control = line.find(kControl);
    if (mark == '#' && control == std::string_view::npos) return std::nullopt;
    if (control != std::string_view::npos) line.remove_prefix(control + kControl.size());
    read.kind = Kind::kBench;
  } else if (mark == '<') {
    read.kind = Kind::kPrinter;
  } else if (mark != '>') {
    return std::nullopt;
  }
  read.text = unescaped(line);
  const bool ended = read.text.ends_with('\n') || read.text.ends_with('\r');
  if (read.kind == Kind::kHost && !ended) read.text += '\n';
  return read;
}

}  // namespace

std::vector<TranscriptLine> read_transcript(std::string_view text) {
  std::vector<TranscriptLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (auto line = read_line(text.substr(0, end), number)) lines.push_back(std::move(*line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace slipstick::test
