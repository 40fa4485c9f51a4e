#pragma once

#include <optional>
#include <string>

#include "core/gcode/parse.h"
#include "sim/machine.h"

namespace slipstick {

/// M31, M75 to M77, M111, M119, M211, M412, M420, M500 to M503 and those of the card: commands that
/// only answer or turn a switch.
///
/// \return What is printed before the "ok"; nothing if `command` is another.
[[nodiscard]] std::optional<std::string> run_service_command(const GcodeCommand& command,
                                                             Machine& machine, Moment now);

}  // namespace slipstick
