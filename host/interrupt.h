#pragma once

namespace slipstick {

/// Turns SIGINT and SIGTERM into questions that loops ask. Made once, at the start of the program.
class Interrupt {
 public:
  /// Handles the signals from now on; the third one ends the program at once.
  static void install();

  /// Whether one came.
  [[nodiscard]] static bool requested();

  /// Whether two came: what moves or heats is to stop at once.
  [[nodiscard]] static bool urgent();
};

}  // namespace slipstick
