#pragma once

#include <string_view>

#include "drivers/clock.h"

namespace slipstick {

/// \file
/// How long a printer may keep silent over a command before that is odd.

/// Three of Marlin's busy intervals of 2 s: moves wait for the planner no longer without a `busy`.
inline constexpr Moment kQuickPatience = std::chrono::seconds(6);

/// For commands that take minutes, on boards built without `busy`.
inline constexpr Moment kBlockingPatience = std::chrono::seconds(30);

/// Whether `text` is a command that Marlin answers only when it is over, which may take minutes:
/// homing, probing, heating, waiting, tool changes.
[[nodiscard]] bool is_blocking(std::string_view text);

[[nodiscard]] inline Moment patience_for(std::string_view text) {
  return is_blocking(text) ? kBlockingPatience : kQuickPatience;
}

}  // namespace slipstick
