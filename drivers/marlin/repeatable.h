#pragma once

#include <string_view>

namespace slipstick {

/// Whether executing `text` twice in a row leaves the printer as executing it once does: setting a
/// temperature, homing. Moves, retractions, dwells, baby-steps and whatever asks the user do not.
[[nodiscard]] bool is_repeatable(std::string_view text);

}  // namespace slipstick
