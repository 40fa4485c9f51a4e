#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace slipstick {

/// The number of a line on its way to the printer: 0 for the M110 that begins a session, then 1, 2,
/// 3…
using LineNumber = std::int64_t;

/// The XOR of all bytes: Marlin's checksum.
///
/// It cannot see two exchanged bytes, nor the same bit flipped in two of them: about one in 300
/// lines with two damaged bytes passes, and the printer then does something nobody asked for. Only
/// the cable helps against that.
[[nodiscard]] constexpr std::uint8_t xor_checksum(std::string_view bytes) {
  std::uint8_t sum = 0;
  for (const char byte : bytes)
    sum = static_cast<std::uint8_t>(sum ^ static_cast<unsigned char>(byte));
  return sum;
}

/// `N<number> <text>*<checksum>` and a newline. \pre `number` ≥ 0.
[[nodiscard]] std::string frame(LineNumber number, std::string_view text);

}  // namespace slipstick
