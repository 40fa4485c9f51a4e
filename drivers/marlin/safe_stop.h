#pragma once

#include <array>
#include <string>
#include <string_view>

namespace slipstick {

/// The commands that make a printer safe to leave alone: heaters and fan off, then motors. In this
/// order, because each may be the last that gets through.
inline constexpr std::array<std::string_view, 4> kSafeStopLines{"M104 S0", "M140 S0", "M107",
                                                                "M84"};

/// Ends a wait for a heater, behind which all else would have to wait. Marlin obeys it as soon as
/// it reads it, whether it has an emergency parser or not, but only without a number; it
/// acknowledges it in its turn.
inline constexpr std::string_view kEndWait = "M108\n";

/// The safe stop as bytes without numbers, for when there is no time to number them: from a signal
/// handler. Marlin takes unnumbered lines at any time.
inline constexpr std::string_view kSafeStopBytes = "\nM108\nM104 S0\nM140 S0\nM107\nM84\n";

/// Heaters and fan off; the motors keep their power, and with it their place.
inline constexpr std::string_view kCoolDownBytes = "\nM108\nM104 S0\nM140 S0\nM107\nM84 S0\n";

/// The same as bytes for a printer whose count of lines is not known: an M110 begins a new count,
/// so that what a bad wire makes of the commands is refused rather than executed.
[[nodiscard]] std::string numbered_safe_stop();

/// The bytes that stop any Marlin at once; the newline before ends a half-written line. Without a
/// number, because Marlin 2 looks for a numbered M112 only when its turn comes.
inline constexpr std::string_view kEmergencyStop = "\nM112\n";

}  // namespace slipstick
