#pragma once

namespace slipstick {

/// Turns signals into questions that loops ask: SIGINT and SIGTERM, and SIGHUP unless it is ignored
/// (nohup). Made once, at the start of the program.
class Interrupt {
 public:
  /// Handles the signals from now on; the third one ends the program at once.
  static void install();

  /// Whether one came.
  [[nodiscard]] static bool requested();

  /// Ctrl-Z (SIGTSTP) pauses from now on, and ends the pause, rather than leaving a hot printer
  /// alone.
  static void pause_by_terminal();

  /// Whether a pause is asked for.
  [[nodiscard]] static bool pause();

  /// The pause is over, whoever ended it.
  static void forget_pause();

  /// Whether two came: what moves or heats is to stop at once.
  [[nodiscard]] static bool urgent();
};

}  // namespace slipstick
