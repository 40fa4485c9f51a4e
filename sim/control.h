#pragma once

#include <string>
#include <string_view>

#include "sim/printer.h"

namespace slipstick {

/// What somebody who stands beside the printer, or a test, does to it while it runs: one line in,
/// one line out, without line ends.
///
/// | line | what it does |
/// | --- | --- |
/// | `fault NAME[=VALUE][@WHEN]` | a fault from now on; WHEN counts from now: seconds, FROM-TO, or
/// lineN more lines | | `mend` | ends all faults | | `press` | presses the button at the printer:
/// ends a wait for somebody | | `reset` | presses its reset button | | `state` | one line of JSON:
/// where it stands, how hot it is, what it has done |
///
/// The answer is "ok", JSON, or "error: " and what is wrong.
[[nodiscard]] std::string obey_control(Printer& printer, std::string_view line);

}  // namespace slipstick
