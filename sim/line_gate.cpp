#include "sim/line_gate.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "core/base/check.h"

namespace slipstick {

namespace {

/// Marlin looks for a second N from the fifth character of an M110 line on.
constexpr std::size_t kSecondNumberFrom = 4;

/// The whole number that `text` begins with, as strtol gives it on a board with 32-bit longs: 0
/// where there is none.
std::int64_t leading_integer(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  std::int32_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc::result_out_of_range) return value;
  return text[0] == '-' ? std::numeric_limits<std::int32_t>::min()
                        : std::numeric_limits<std::int32_t>::max();
}

unsigned char checksum(std::string_view text) {
  unsigned char sum = 0;
  for (const char c : text) sum = static_cast<unsigned char>(sum ^ static_cast<unsigned char>(c));
  return sum;
}

}  // namespace

Verdict LineGate::judge(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  if (line.empty() || line[0] != 'N') return Verdict::kAccepted;

  std::size_t at = 0;
  const bool renumbers = line.find("M110") != std::string_view::npos;
  if (renumbers) {
    const std::size_t second = line.find('N', kSecondNumberFrom);
    if (second != std::string_view::npos) at = second;
  }
  const std::int64_t number = leading_integer(line.substr(at + 1));
  if (number != last_number_ + 1 && !renumbers) {
    const bool duplicate = number == last_number_ || number == last_number_ - 1;
    return duplicate ? Verdict::kDuplicate : Verdict::kWrongNumber;
  }

  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos) return Verdict::kNoChecksum;
  if (leading_integer(line.substr(star + 1)) != checksum(line.substr(0, star))) {
    return Verdict::kWrongChecksum;
  }
  last_number_ = number;
  return Verdict::kAccepted;
}

std::string_view error_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::kWrongNumber:
      return "Line Number is not Last Line Number+1, Last Line: ";
    case Verdict::kWrongChecksum:
      return "checksum mismatch, Last Line: ";
    case Verdict::kNoChecksum:
      return "No Checksum with line number, Last Line: ";
    case Verdict::kAccepted:
    case Verdict::kDuplicate:
      break;
  }
  SLIPSTICK_CHECK(verdict != Verdict::kAccepted && verdict != Verdict::kDuplicate);
  return {};
}

}  // namespace slipstick
