#pragma once

namespace slipstick {

/// Turns SIGINT and SIGTERM into a question that loops ask. Made once, at the start of the program.
class Interrupt {
 public:
  /// Handles the signals from now on; a second one ends the program at once.
  static void install();

  /// Whether one came.
  [[nodiscard]] static bool requested();
};

}  // namespace slipstick
