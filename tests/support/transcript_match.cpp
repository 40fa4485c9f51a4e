// Whether two printers say the same: temperatures are compared as numbers, all else as text.
#include "tests/support/transcript_match.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/number_text.h"
#include "sim/heater.h"

namespace slipstick::test {
namespace {

std::string_view take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

/// The number behind `name` in `word`; nothing if the word is another.
std::optional<double> value_of(std::string_view word, std::string_view name) {
  if (!word.starts_with(name)) return std::nullopt;
  return parse_number(word.substr(name.size()));
}

bool is_near(std::optional<double> a, std::optional<double> b, double most) {
  return a && b && std::abs(*a - *b) <= most;
}

bool is_same_word(std::string_view heard, std::string_view expected, const Tolerance& tolerance) {
  if (heard == expected) return true;
  const auto is_near_celsius = [&](std::string_view name, double noise) {
    const auto celsius = value_of(expected, name);
    const double rise = celsius ? std::max(0.0, *celsius - Heater::kRoomCelsius) : 0;
    return is_near(value_of(heard, name), celsius, noise + tolerance.rise * rise);
  };
  if (is_near_celsius("T:", tolerance.celsius)) return true;
  if (is_near_celsius("B:", tolerance.bed_celsius)) return true;
  for (const std::string_view name : {"@:", "B@:"}) {
    if (value_of(heard, name) && value_of(expected, name)) return true;
  }
  return is_near(value_of(heard, "W:"), value_of(expected, "W:"), tolerance.wait_seconds);
}

}  // namespace

bool says_the_same(std::string_view heard, std::string_view expected, const Tolerance& tolerance) {
  while (!heard.empty() && !expected.empty()) {
    if (!is_same_word(take_word(heard), take_word(expected), tolerance)) return false;
  }
  return heard.empty() && expected.empty();
}

}  // namespace slipstick::test
