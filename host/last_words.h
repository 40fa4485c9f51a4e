#pragma once

namespace slipstick {

/// While it lives, a crash of this process (a failed check, a fatal signal) first turns the
/// printer's heaters off: constant bytes, one write, nothing that is not async-signal-safe. SIGKILL
/// it cannot see.
///
/// At most one at a time.
class LastWords {
 public:
  /// \param descriptor where the printer listens; -1 makes it do nothing.
  explicit LastWords(int descriptor);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;
};

}  // namespace slipstick
