#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "drivers/transport.h"
#include "sim/printer.h"
#include "sim/sim_options.h"
#include "sim/virtual_clock.h"

namespace slipstick {

/// The embedded printer as a transport, in virtual time: waiting for a byte makes time pass,
/// computing does not.
///
/// Like a serial port it takes up to 4 kB that the board has not read yet; a write beyond that
/// waits. While the cable is out it fails with kUnavailable. Threads as in `Transport`.
class SimTransport final : public Transport {
 public:
  static constexpr std::size_t kTtyBuffer = 4096;

  explicit SimTransport(const SimOptions& options, const Planner::Sink& sink = {});

  [[nodiscard]] Result<std::size_t> read_some(std::span<char> buffer,
                                              std::chrono::microseconds patience) override;
  [[nodiscard]] Result<std::size_t> write_some(std::string_view bytes,
                                               std::chrono::microseconds patience) override;
  [[nodiscard]] Result<void> write_all(std::string_view bytes,
                                       std::chrono::microseconds patience) override;
  void shut_down() noexcept override;
  [[nodiscard]] std::string_view name() const override { return "sim:"; }

  /// The printer's time, for everything above that waits or measures.
  [[nodiscard]] const Clock& clock() const { return clock_; }
  /// The thread that reads and writes.
  [[nodiscard]] const Printer& printer() const { return printer_; }
  /// Lets the machine finish what it has, at most `most`. The thread that reads and writes.
  void run_down(Moment most);

 private:
  /// Lets time pass until the printer's next event, but not beyond `deadline`.
  void pass_time(Moment deadline);
  void advance_to(Moment to);
  [[nodiscard]] Moment steady_now() const;

  Printer printer_;
  VirtualClock clock_;
  bool realtime_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::atomic<bool> shut_down_{false};
  std::mutex mutex_;  ///< Protects nothing but the sleep that `woken_` ends.
  std::condition_variable woken_;
};

}  // namespace slipstick
