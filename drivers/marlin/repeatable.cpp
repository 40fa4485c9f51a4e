#include "drivers/marlin/repeatable.h"

#include <algorithm>
#include <array>

#include "core/gcode/parse.h"

namespace slipstick {
namespace {

constexpr std::array kOnceG{0, 1, 2, 3, 5, 6};
constexpr std::array kOnceM{0, 1, 125, 226, 290, 600, 701, 702};

}  // namespace

bool is_repeatable(std::string_view text) {
  const auto command = parse_gcode(text);
  if (!command) return false;
  if (command->letter() == 'G') return !std::ranges::binary_search(kOnceG, command->code());
  return command->letter() != 'M' || !std::ranges::binary_search(kOnceM, command->code());
}

}  // namespace slipstick
