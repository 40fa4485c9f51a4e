#include "drivers/marlin/print_state.h"

#include <algorithm>
#include <array>

#include "core/gcode/parse.h"

namespace slipstick {
namespace {

constexpr std::size_t kZ = 2;
constexpr std::size_t kE = 3;
constexpr double kFullFan = 255;
constexpr std::array kRenamingG{52, 54, 55, 56, 57, 58, 59};
constexpr std::array kRenamingM{206, 218, 428};

// A bare G92 renames all axes, `G92 E0` no place.
bool renames(const GcodeCommand& command) {
  const int code = command.code();
  if (command.letter() == 'M') return std::ranges::binary_search(kRenamingM, code);
  if (command.letter() != 'G') return false;
  if (code != 92) return std::ranges::binary_search(kRenamingG, code);
  return command.has('X') || command.has('Y') || command.has('Z') || !command.has('E');
}

// The temperature of M104, M109, M140 or M190.
std::optional<double> celsius(const GcodeCommand& command) {
  const auto heat = command.value('S');
  return heat ? heat : command.value('R');
}

}  // namespace

bool knows_place(const PrintState& state) {
  return state.position[0] && state.position[1] && state.position[kZ];
}

void PrintStateTracker::follow(std::string_view text) {
  const auto command = parse_gcode(text);
  if (!command) return;
  const Position before = state_.position;
  state_.position = place_.follow(text);
  state_.relative = place_.relative();
  state_.relative_extrusion = place_.relative_extrusion();
  state_.renamed |= renames(*command);
  if (command->letter() == 'M') follow_m(*command);
  if (command->letter() == 'G' && command->code() <= 3) follow_move(*command, before);
  if (command->letter() == 'T' && command->code() != tool_) {
    tool_ = command->code();
    state_.nozzle.reset();
  }
}

void PrintStateTracker::follow_m(const GcodeCommand& command) {
  switch (command.code()) {
    case 104:
    case 109:
      return follow_nozzle(command);
    case 140:
    case 190:
      if (const auto heat = celsius(command)) state_.bed = heat;
      return;
    case 106:
      if (command.value('P').value_or(0) == 0) state_.fan = command.value('S').value_or(kFullFan);
      return;
    case 107:
      if (command.value('P').value_or(0) == 0) state_.fan = 0;
      return;
    default:
      return;
  }
}

void PrintStateTracker::follow_nozzle(const GcodeCommand& command) {
  const auto heat = celsius(command);
  if (heat && command.value('T').value_or(tool_) == tool_) state_.nozzle = heat;
}

void PrintStateTracker::follow_move(const GcodeCommand& command, const Position& before) {
  if (const auto feed = command.value('F'); feed && *feed > 0) state_.feed = feed;
  const auto e = command.value('E');
  const auto z = state_.position[kZ];
  if (!e || !z || !(command.has('X') || command.has('Y'))) return;
  if (*e > (state_.relative_extrusion ? 0 : before[kE].value_or(0)))
    state_.top = std::max(state_.top.value_or(*z), *z);
}

}  // namespace slipstick
