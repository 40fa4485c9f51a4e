#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace slipstick {

/// \file
/// What Marlin asks of a host (HOST_ACTION_COMMANDS, HOST_PROMPT_SUPPORT of 2.1.2): whole lines.

[[nodiscard]] std::string action_line(std::string_view action);

/// Ends the prompt there was and shows another, with its buttons.
[[nodiscard]] std::string prompt_lines(std::string_view text,
                                       std::initializer_list<std::string_view> buttons);

}  // namespace slipstick
