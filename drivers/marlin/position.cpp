#include "drivers/marlin/position.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/gcode/parse.h"

namespace slipstick {
namespace {

constexpr std::string_view kAxes = "XYZE";
constexpr std::size_t kE = 3;
/// Reports have two decimals; boards count in single precision.
constexpr double kSame = 0.011;
constexpr double kApart = 0.03;

/// Commands that move, or rename places, in ways that are not followed.
constexpr std::array kFollowedG{0, 1, 2, 3, 4, 20, 21, 28, 90, 91, 92};
constexpr std::array kUnfollowedM{0,   1,   24,  25,  125, 206, 211, 218, 428,
                                  501, 502, 600, 603, 665, 666, 701, 702, 999};

/// Takes `X:1.50` off the front of `text`.
std::optional<double> take_axis(std::string_view& text, char axis) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  if (text.size() < 2 || text[0] != axis || text[1] != ':') return std::nullopt;
  text.remove_prefix(2);
  while (text.starts_with(' ')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

}  // namespace

void PositionTracker::move(const GcodeCommand& command) {
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const auto value = command.value(kAxes[axis]);
    if (!value) continue;
    auto& at = position_[axis];
    if (!(axis == kE ? relative_e_ : relative_)) {
      at = value;
    } else if (at) {
      *at += *value;
    }
  }
}

void PositionTracker::rename(const GcodeCommand& command) {
  bool any = false;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if (!command.has(kAxes[axis])) continue;
    position_[axis] = command.value(kAxes[axis]);
    any = true;
  }
  if (!any) position_ = {};
}

const Position& PositionTracker::follow(std::string_view text) {
  const auto command = parse_gcode(text);
  if (!command) return position_;
  const int code = command->code();
  if (command->letter() == 'M') {
    if (code == 82 || code == 83) relative_e_ = code == 83;
    if (std::ranges::binary_search(kUnfollowedM, code)) position_ = {};
    return position_;
  }
  if (command->letter() == 'T') {
    position_ = {{{}, {}, {}, position_[kE]}};
    return position_;
  }
  if (!std::ranges::binary_search(kFollowedG, code)) position_ = {};
  if (code <= 3) move(*command);
  if (code == 92) rename(*command);
  if (code == 90 || code == 91) relative_ = relative_e_ = code == 91;
  if (code == 20 || code == 21) millimetres_ = code == 21;
  if (code == 28) position_ = {{{}, {}, {}, position_[kE]}};
  if (!millimetres_) position_ = {};
  return position_;
}

void PositionTracker::learn(const Position& report) {
  if (millimetres_) position_ = report;
}

bool PositionTracker::lost() const {
  const bool place = position_[0] && position_[1] && position_[2];
  return millimetres_ && ((relative_ && !place) || (relative_e_ && !position_[kE]));
}

std::optional<Position> parse_position(std::string_view text) {
  Position position;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    position[axis] = take_axis(text, kAxes[axis]);
    if (!position[axis]) return std::nullopt;
  }
  return text.starts_with(" Count ") ? std::optional(position) : std::nullopt;
}

bool fits(const Position& report, const Position& place) {
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    if (place[axis] && std::abs(*report[axis] - *place[axis]) > kSame) return false;
  }
  return true;
}

bool tells_apart(const Position& before, const Position& after) {
  for (std::size_t axis = 0; axis < after.size(); ++axis) {
    if (!after[axis]) continue;
    if (!before[axis] || std::abs(*before[axis] - *after[axis]) > kApart) return true;
  }
  return false;
}

Executed executed(const Position& report, const Position& before, const Position& after) {
  if (fits(report, after)) return Executed::kYes;
  return fits(report, before) ? Executed::kNo : Executed::kUnclear;
}

}  // namespace slipstick
