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

Verdict LineGate::out_of_sequence(std::int64_t number) const {
  constexpr std::int64_t kRemembered = 40;
  const std::int64_t back = last_number_ - number;
  if (rules_.duplicates == Duplicates::kDropLastTwo && (back == 0 || back == 1)) {
    return Verdict::kDropped;
  }
  if (rules_.duplicates == Duplicates::kSkipLastForty && back >= 0 && back < kRemembered) {
    return Verdict::kSkipped;
  }
  return Verdict::kWrongNumber;
}

Verdict LineGate::check(std::string_view line) const {
  const std::size_t star = rules_.first_star ? line.find('*') : line.rfind('*');
  if (star == std::string_view::npos) return Verdict::kNoChecksum;
  const bool right = leading_integer(line.substr(star + 1)) == checksum(line.substr(0, star));
  return right ? Verdict::kAccepted : Verdict::kWrongChecksum;
}

Verdict LineGate::judge(std::string_view line) {
  if (rules_.numbers == NumberCheck::kNone) return Verdict::kAccepted;
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  std::size_t at = line.find('N');
  if (at != 0 && rules_.numbers != NumberCheck::kAnyN) at = std::string_view::npos;
  if (at == std::string_view::npos) {
    const bool lone = rules_.star_needs_number && line.find('*') != std::string_view::npos;
    return lone ? Verdict::kNoNumber : Verdict::kAccepted;
  }
  if (rules_.numbers == NumberCheck::kChecksumOnly) {
    return check(line) == Verdict::kWrongChecksum ? Verdict::kDropped : Verdict::kAccepted;
  }
  const bool renumbers = line.find("M110") != std::string_view::npos;
  if (const std::size_t second = line.find('N', kSecondNumberFrom);
      renumbers && second != std::string_view::npos) {
    at = second;
  }
  seen_number_ = leading_integer(line.substr(at + 1));
  if (seen_number_ != last_number_ + 1 && !renumbers) return out_of_sequence(seen_number_);
  const Verdict verdict = check(line);
  if (verdict == Verdict::kAccepted) last_number_ = seen_number_;
  return verdict;
}

std::string_view error_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::kWrongNumber:
      return "Line Number is not Last Line Number+1, Last Line: ";
    case Verdict::kWrongChecksum:
      return "checksum mismatch, Last Line: ";
    case Verdict::kNoChecksum:
      return "No Checksum with line number, Last Line: ";
    case Verdict::kNoNumber:
      return "No Line Number with checksum, Last Line: ";
    case Verdict::kAccepted:
    case Verdict::kDropped:
    case Verdict::kSkipped:
      break;
  }
  SLIPSTICK_CHECK(verdict > Verdict::kSkipped);
  return {};
}

}  // namespace slipstick
