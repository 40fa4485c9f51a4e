#include "drivers/marlin/interjection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/gcode/parse.h"

namespace slipstick {
namespace {

constexpr std::array kHarmlessM{73,  104, 106, 107, 117, 140, 150, 201, 203, 204, 205,
                                220, 221, 290, 300, 301, 304, 355, 413, 486, 900};
constexpr double kFullFan = 255;

struct Dial {
  std::string_view name;
  std::optional<double> Adjustment::*value;
  double min;
  double max;
  std::string_view command;  ///< With a place for the value.
  double unit = 1;           ///< Of the command.
};

constexpr std::array kDials{
    Dial{"feed", &Adjustment::feed, 10, 300, "M220 S{:.0f}"},
    Dial{"flow", &Adjustment::flow, 50, 200, "M221 S{:.0f}"},
    Dial{"z", &Adjustment::z, -0.5, 0.5, "M290 Z{:.2f}"},
    Dial{"nozzle", &Adjustment::nozzle, 0, 300, "M104 S{:.0f}"},
    Dial{"bed", &Adjustment::bed, 0, 150, "M140 S{:.0f}"},
    Dial{"fan", &Adjustment::fan, 0, 1, "M106 S{:.0f}", 1 / kFullFan},
};

}  // namespace

Result<Line> command_line(std::string_view text) {
  auto line = normalise(text);
  if (!line) return fail(line.error());
  if (!*line) return fail(ErrorCode::kInput, "there is no command in it");
  return **std::move(line);
}

Result<Line> interjection(std::string_view text) {
  auto line = command_line(text);
  if (!line) return line;
  const auto command = parse_gcode(line->text());
  if (command && command->letter() == 'M' &&
      std::ranges::binary_search(kHarmlessM, command->code())) {
    return line;
  }
  return fail(ErrorCode::kInput,
              fmt::format("{}: only what neither moves nor waits can be said in a print, as M104, "
                          "M106, M117, M220 or M290",
                          line->text()));
}

std::optional<double>* member_of(Adjustment& adjustment, std::string_view name) {
  const auto dial = std::ranges::find(kDials, name, &Dial::name);
  return dial == kDials.end() ? nullptr : &(adjustment.*dial->value);
}

Result<std::vector<Line>> lines_of(const Adjustment& adjustment) {
  std::vector<Line> lines;
  for (const Dial& dial : kDials) {
    const std::optional<double>& value = adjustment.*dial.value;
    if (!value) continue;
    if (!(*value >= dial.min && *value <= dial.max)) {
      return fail(ErrorCode::kInput, fmt::format("{}: {} is not between {} and {}", dial.name,
                                                 *value, dial.min, dial.max));
    }
    lines.push_back(*Line::make(fmt::format(fmt::runtime(dial.command), *value / dial.unit)));
  }
  if (lines.empty()) return fail(ErrorCode::kInput, "nothing is to be different");
  return lines;
}

}  // namespace slipstick
