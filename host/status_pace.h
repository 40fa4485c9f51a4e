#pragma once

#include <array>
#include <deque>
#include <optional>

#include "drivers/marlin/line.h"
#include "drivers/marlin/print_state.h"

namespace slipstick {

/// Thins out what a program writes on the printer's display.
///
/// Each M73 and M117 takes a place in the printer's queue, and programs with one a move make its
/// planner run dry. Of each kind one goes out per second of moves at the program's own speeds, the
/// latest; before a command that the printer may wait at, and at the end, whatever is latest. A
/// pure function of the program: a print that is taken up counts the same lines. All other lines
/// pass, in their order.
class StatusPace {
 public:
  /// Between two lines of a kind.
  static constexpr double kSeconds = 1;

  /// The program goes on with `line`.
  void push(Line line);
  /// It is over.
  void end();
  /// The next line to send; nothing when the program has to go on first.
  [[nodiscard]] std::optional<Line> pop();

 private:
  struct Kind {
    std::optional<Line> latest;  ///< Not sent yet.
    double quiet = kSeconds;     ///< Seconds of moves since the last was sent.
  };

  void send(Kind& kind);

  std::array<Kind, 2> kinds_;  ///< M73, M117.
  PrintStateTracker state_;
  std::deque<Line> ready_;  ///< At most one line, and one of each kind before it.
};

}  // namespace slipstick
