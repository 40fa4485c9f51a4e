#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// A reliable-or-dead, ordered stream of bytes to and from one printer.
///
/// The serial port, the simulated printer, a pseudo-terminal and a socket are all this and nothing
/// more, so that everything above is tested against the code that prints. A transport knows nothing
/// of lines, checksums or G-code. (The wire may still damage bytes: reliable is the interface, not
/// the cable.)
///
/// Threads: one thread reads and writes; `shut_down` may be called by any thread at any time.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// Waits until at least one byte came and moves what is there, up to `buffer.size()`, into it.
  ///
  /// \return how many bytes came, never 0.
  ///   kTimedOut: none came within `patience`; the stream is still good.
  ///   kUnavailable: the other side is gone; every later call says the same.
  ///   kCancelled: `shut_down` was called.
  [[nodiscard]] virtual Result<std::size_t> read_some(std::span<char> buffer,
                                                      std::chrono::microseconds patience) = 0;

  /// Hands over as many of `bytes` as the other side takes, as soon as that is at least one.
  ///
  /// \pre `bytes` is not empty. \return how many, never 0. Errors as for `read_some`.
  [[nodiscard]] virtual Result<std::size_t> write_some(std::string_view bytes,
                                                       std::chrono::microseconds patience) = 0;

  /// Hands over all of `bytes`, or fails; after a failure nobody knows how many went out.
  /// Errors as for `read_some`.
  [[nodiscard]] virtual Result<void> write_all(std::string_view bytes,
                                               std::chrono::microseconds patience) = 0;

  /// Forgets what was handed over and has not left this machine, where that is possible.
  virtual void discard_output() noexcept {}

  /// Switches DTR, whose falling edge resets most boards.
  /// \return whether there is such a line.
  virtual bool set_dtr(bool /*on*/) noexcept { return false; }

  /// Makes the call in progress and all later ones fail with kCancelled. Safe to call twice.
  virtual void shut_down() noexcept = 0;

  /// The descriptor that bytes go out through, for last words from a signal handler; -1 if there is
  /// none.
  [[nodiscard]] virtual int descriptor() const noexcept { return -1; }

  /// For messages: "pty:/tmp/printer".
  [[nodiscard]] virtual std::string_view name() const = 0;
};

}  // namespace slipstick
