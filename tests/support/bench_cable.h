#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slipstick::test {

/// The cable of a test bench, that does harm on command: each harms what comes next, and so many
/// times.
///
/// "flip-rx N" and "flip-tx N" turn over a bit of the next N bytes to the board or to the host, and
/// "flip-rx-every N" of every N-th to the board; "drop-rx N" and "drop-tx N" lose bytes,
/// "swallow-ok N" and "dup-ok N" lose and double an answer; "mute 1" and "deaf 1" lose all of one
/// direction until "mute 0" and "deaf 0". "noise N" puts any N bytes before the next line to the
/// host: none here, `take_noise` tells how many were meant.
class BenchCable {
 public:
  /// \return Whether the command is one of these.
  bool command(std::string_view words);

  /// What the host sends, as it reaches the board.
  [[nodiscard]] std::string to_board(std::string_view bytes);
  /// A line that the board says, as it reaches the host: as often as that, which may be never.
  [[nodiscard]] std::vector<std::string> to_host(std::string line);

  [[nodiscard]] std::size_t take_noise();

 private:
  std::size_t flip_rx_ = 0, flip_tx_ = 0, drop_rx_ = 0, drop_tx_ = 0;
  std::size_t swallow_ok_ = 0, double_ok_ = 0, mute_ = 0, deaf_ = 0, noise_ = 0;
  std::size_t flip_every_ = 0;
  std::size_t since_flip_ = 0;
};

}  // namespace slipstick::test
