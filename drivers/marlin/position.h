#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace slipstick {

class GcodeCommand;

/// X, Y, Z and E in mm as the printer counts them; nothing where that is not known.
using Position = std::array<std::optional<double>, 4>;

/// Where lines of G-code leave the printer, as M114 would tell.
///
/// Begins in absolute coordinates, as a board does. Whatever else moves the nozzle (homing,
/// probing, parking, tool changes, inches, settings loaded) makes its place unknown.
class PositionTracker {
 public:
  /// The position after `text` too. \pre `text` holds no line end.
  const Position& follow(std::string_view text);

  /// The printer reports where the last line left it.
  void learn(const Position& report);

  [[nodiscard]] const Position& position() const { return position_; }
  /// Moves are relative to a place that is not known: only a report helps.
  [[nodiscard]] bool lost() const;
  [[nodiscard]] bool relative() const { return relative_; }
  [[nodiscard]] bool relative_extrusion() const { return relative_e_; }

 private:
  void move(const GcodeCommand& command);
  void rename(const GcodeCommand& command);

  Position position_;
  bool relative_ = false;
  bool relative_e_ = false;
  bool millimetres_ = true;
};

/// The report of M114, `X:0.00 Y:0.00 Z:0.00 E:0.00 Count …`; nothing unless all of it is there.
[[nodiscard]] std::optional<Position> parse_position(std::string_view text);

/// What a report tells of a line.
enum class Executed : unsigned char { kYes, kNo, kUnclear };

/// Whether a report can tell if a line was executed that leads from `before` to `after`: some axis
/// moves by more than twice what two decimals can say, or from an unknown place (after homing) to a
/// known one.
[[nodiscard]] bool tells_apart(const Position& before, const Position& after);

/// \pre tells_apart(before, after).
[[nodiscard]] Executed executed(const Position& report, const Position& before,
                                const Position& after);

}  // namespace slipstick
