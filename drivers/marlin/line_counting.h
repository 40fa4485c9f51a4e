#pragma once

#include <string_view>

namespace slipstick {

/// Whether the firmware of this name (M115) refuses numbered lines that are out of their order.
///
/// RepRapFirmware 3.5 executes a line whatever its number and drops a damaged one without a word;
/// Klipper 0.12 looks at neither number nor checksum. Over such a link no sender can know what was
/// lost.
[[nodiscard]] constexpr bool counts_lines(std::string_view firmware) {
  return firmware.find("RepRapFirmware") == firmware.npos &&
         firmware.find("Klipper") == firmware.npos;
}

}  // namespace slipstick
