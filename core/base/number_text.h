#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slipstick {

/// \file
/// Numbers as text, whatever the locale.

/// Appends the shortest text that reads back to the very same value. \pre `value` is finite.
void append_exact(std::string& text, double value);

/// Appends `value` with at most `decimals` digits behind the point, trailing zeros dropped, never
/// "-0". \pre `value` is finite and |value| < 10^12.
void append_rounded(std::string& text, double value, int decimals);

/// The value of the whole of `text`, or nothing. Accepts what C's strtod does except hexadecimal,
/// blanks, infinities and NaN.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

}  // namespace slipstick
