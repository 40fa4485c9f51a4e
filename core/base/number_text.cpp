#include "core/base/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/base/check.h"

namespace slipstick {

void append_exact(std::string& text, double value) {
  SLIPSTICK_CHECK(std::isfinite(value));
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  SLIPSTICK_CHECK(error == std::errc());
  text.append(buffer.data(), end);
}

void append_rounded(std::string& text, double value, int decimals) {
  SLIPSTICK_CHECK(std::abs(value) < 1e12);
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::fixed, decimals);
  SLIPSTICK_CHECK(error == std::errc());
  std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  if (decimals > 0) {
    digits = digits.substr(0, digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.remove_suffix(1);
  }
  text += digits == "-0" ? "0" : digits;
}

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

}  // namespace slipstick
