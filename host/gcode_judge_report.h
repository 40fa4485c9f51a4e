#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/gcode_judge.h"

namespace slipstick {

/// All of it, as `slipstick sim --gcode --json` prints it. The same verdict is the same text.
[[nodiscard]] nlohmann::ordered_json gcode_judge_report(const GcodeVerdict& verdict,
                                                        const PrintSettings& settings);

/// For a person: each fault with its layer and place, then the sums.
[[nodiscard]] std::string gcode_judge_text(const GcodeVerdict& verdict);

}  // namespace slipstick
