#pragma once

#include <optional>
#include <string_view>

#include "drivers/marlin/position.h"

namespace slipstick {

class GcodeCommand;

/// What the lines of a print so far have made of the printer: all that a print needs to be taken up
/// again. Nothing where the lines do not tell.
struct PrintState {
  Position position;  ///< In the coordinates of the lines.
  bool relative = false;
  bool relative_extrusion = false;
  std::optional<double> feed;    ///< mm/min
  std::optional<double> nozzle;  ///< °C asked for, of the tool in use.
  std::optional<double> bed;     ///< °C asked for.
  std::optional<double> fan;     ///< 0 to 255.
  std::optional<double> top;     ///< mm: the greatest height at which plastic was laid.
  bool renamed = false;          ///< The coordinates may not be the machine's (G92 X5, M206, G54).

  friend bool operator==(const PrintState&, const PrintState&) = default;
};

/// Whether the lines tell where the nozzle is.
[[nodiscard]] bool knows_place(const PrintState& state);

/// Follows a print line by line.
class PrintStateTracker {
 public:
  /// The print goes on with `text`. \pre `text` holds no line end.
  void follow(std::string_view text);

  [[nodiscard]] const PrintState& state() const { return state_; }

 private:
  void follow_m(const GcodeCommand& command);
  void follow_move(const GcodeCommand& command, const Position& before);
  void follow_nozzle(const GcodeCommand& command);

  PositionTracker place_;
  PrintState state_;
  int tool_ = 0;
};

}  // namespace slipstick
