#include "sim/host_talk.h"

namespace slipstick {

std::string action_line(std::string_view action) {
  return std::string("//action:").append(action).append("\n");
}

std::string prompt_lines(std::string_view text, std::initializer_list<std::string_view> buttons) {
  std::string lines = action_line("prompt_end") + action_line("prompt_begin " + std::string(text));
  for (const std::string_view button : buttons) {
    lines += action_line("prompt_button " + std::string(button));
  }
  return lines + action_line("prompt_show");
}

}  // namespace slipstick
