#pragma once

#include <string>
#include <string_view>

#include "sim/machine.h"

namespace slipstick {

/// \file
/// What Marlin 2.1.2 says, to the byte. Whole lines with their line ends unless a name says
/// otherwise.

[[nodiscard]] std::string settings_report(const Machine& machine);
/// X:… Count …
[[nodiscard]] std::string position_report(const Machine& machine, Moment now);
/// " T:… B:… @:… B@:…", no line end: M105 puts "ok" before it, waits put " W:…" behind it.
[[nodiscard]] std::string temperature_text(const Machine& machine);

// One line each, as M503 shows it after its "echo:" and as the command without words shows it
// alone.
[[nodiscard]] std::string steps_line(const MotionLimits& limits);
[[nodiscard]] std::string speed_line(const MotionLimits& limits);
[[nodiscard]] std::string acceleration_max_line(const MotionLimits& limits);
[[nodiscard]] std::string acceleration_line(const MotionLimits& limits);
[[nodiscard]] std::string advanced_line(const MotionLimits& limits);

inline constexpr std::string_view kOk = "ok\n";
inline constexpr std::string_view kColdExtrusion = "echo: cold extrusion prevented\n";
inline constexpr std::string_view kLongExtrusion = "echo: too long extrusion prevented\n";
inline constexpr std::string_view kBadArc = "Error:G2/G3 bad parameters\n";

}  // namespace slipstick
