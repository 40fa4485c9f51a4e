#pragma once

#include <string_view>

namespace slipstick {

/// Whether executing `text` twice in a row leaves the printer and the print as executing it once
/// does: setting a temperature, homing, waiting. Moves do not, nor baby-steps, nor whatever asks
/// the user; what is no G-code does not either.
[[nodiscard]] bool is_repeatable(std::string_view text);

}  // namespace slipstick
