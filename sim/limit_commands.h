#pragma once

#include <optional>
#include <string>

#include "core/gcode/parse.h"
#include "sim/machine.h"

namespace slipstick {

/// Runs `command` if it is one that sets or reports how the machine may move and extrude: M92,
/// M201, M203, M204, M205, M220, M221, M302. \return What it prints; nothing if it is another
/// command.
[[nodiscard]] std::optional<std::string> run_limit_command(const GcodeCommand& command,
                                                           Machine& machine);

}  // namespace slipstick
