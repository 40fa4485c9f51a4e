#pragma once

namespace slipstick {

/// While it lives, a crash of this process (a failed check, a fatal signal) first turns the
/// printer's heaters and motors off, and a journal of the print is told so: constant bytes, one
/// write each, nothing that is not async-signal-safe. SIGKILL it cannot see.
///
/// At most one at a time.
class LastWords {
 public:
  /// \param descriptor where the printer listens; -1 makes it do nothing.
  /// \param journal a file that is open for appending, or -1.
  LastWords(int descriptor, int journal);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;
};

}  // namespace slipstick
