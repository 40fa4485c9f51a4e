#include "drivers/marlin/board_settings.h"

#include <algorithm>
#include <array>

#include "core/gcode/parse.h"

namespace slipstick {
namespace {

constexpr std::array kSettings{92,  201, 203, 204, 205, 207, 208, 220,
                               221, 301, 302, 304, 592, 593, 900, 907};

bool sets_up(const Line& line) {
  const auto command = parse_gcode(line.text());
  return command && command->letter() == 'M' &&
         std::ranges::binary_search(kSettings, command->code());
}

}  // namespace

void BoardSettings::follow(const Line& line) {
  if (!sets_up(line)) return;
  std::erase(lines_, line);
  if (lines_.size() == kMax) lines_.erase(lines_.begin());
  lines_.push_back(line);
}

}  // namespace slipstick
