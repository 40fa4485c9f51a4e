#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/vec.h"
#include "drivers/clock.h"
#include "sim/byte_pipe.h"
#include "sim/faults/fault_set.h"
#include "sim/firmware.h"
#include "sim/machine.h"

namespace slipstick {

struct PrinterOptions {
  int baud = 0;            ///< 0 is native USB: no pacing, and the board lets the host wait.
  Moment latency{0};       ///< Tick of the adapter's timer: when the host is given what arrived.
  double corrupt = 0;      ///< Share of bytes damaged, each way.
  std::uint64_t seed = 1;  ///< Of all chance.
  MachineOptions machine = {};
  Personality personality = default_personality();
  std::vector<FaultSpec> faults = {};
};

/// What happened on the wire and on the machine so far.
struct PrinterStatistics {
  MotionStatistics motion;
  std::int64_t lines_accepted = 0;
  std::int64_t resends_requested = 0;
  std::int64_t bytes_overrun = 0;  ///< Came to a full receive buffer and were lost.
  std::int64_t bytes_damaged = 0;  ///< Both ways, by `corrupt`.
  std::int64_t faults = 0;         ///< How often the faults by name did harm.
};

/// A printer with a board, Marlin 2.1.2's unless another personality is given: bytes in, time,
/// bytes out. Deterministic.
///
/// It is switched on at moment 0 and says "start" 70 ms later. Nothing happens but by `advance`.
class Printer {
 public:
  explicit Printer(const PrinterOptions& options, const Planner::Sink& sink = {});

  /// The host sends `bytes` at `at`. \pre `at` never goes back.
  void receive(std::string_view bytes, Moment at);

  /// How many bytes are still on their way to the board (or wait because it is busy, with USB).
  [[nodiscard]] std::size_t unread() const { return to_board_.pending(); }

  /// Lets time pass until `to`; an earlier moment changes nothing.
  void advance(Moment to);
  [[nodiscard]] Moment now() const { return now_; }
  /// When something may happen next; nothing when the printer only waits for the host.
  [[nodiscard]] std::optional<Moment> next_event() const;

  /// Moves what the host has received by now into `buffer`. \return How many bytes.
  std::size_t take(std::span<char> buffer) { return to_host_.take(buffer, now_); }
  /// When the first byte not yet taken reaches the host.
  [[nodiscard]] std::optional<Moment> output_at() const { return to_host_.next_at(); }

  /// Starts the board anew: heaters lose their targets, motion stops where it is, "start" comes
  /// again.
  void reset(ResetCause cause = ResetCause::kPowerUp);

  /// A fault from now on; its time and line count from here.
  /// \return kInput if there are too many.
  [[nodiscard]] Result<void> suffer(const FaultSpec& fault);
  /// Ends all faults.
  void mend() { faults_.mend(*this); }
  /// Somebody presses the button at the printer: a wait for them ends.
  void press_button() { firmware_->press_button(); }

  // What faults do to it.
  /// The firmware stops for good of itself.
  void kill();
  /// `words` come from the board that are no answer.
  void say(std::string_view words);
  /// The firmware's main loop stands, or runs again.
  void freeze() { frozen_ = true; }
  void thaw() { frozen_ = false; }
  /// The cable is pulled out, or put in again; meanwhile nothing comes through either way.
  void unplug();
  void plug_in() { plugged_ = true; }
  void break_heater(Heater Machine::*heater, HeaterDefect defect);
  /// The motor turns and nothing comes, or does again.
  void run_out_of_filament() { machine_->spool->empty = true; }
  void reload_filament() { machine_->spool->empty = false; }

  [[nodiscard]] bool plugged() const { return plugged_; }
  [[nodiscard]] std::int64_t lines_accepted() const { return firmware_->lines_accepted(); }

  [[nodiscard]] const Machine& machine() const { return *machine_; }
  [[nodiscard]] PrinterStatistics statistics() const;

 private:
  void settle();
  bool deliver();
  bool think();
  void transmit(std::string text);
  [[nodiscard]] bool processor_free() const { return !frozen_ && now_ >= busy_until_; }

  std::unique_ptr<Machine> machine_;  ///< Behind a pointer so that a Printer can be moved.
  Personality personality_;
  std::unique_ptr<Firmware> firmware_;
  BytePipe to_board_;
  BytePipe to_host_;
  FaultSet faults_;
  bool frozen_ = false;
  bool plugged_ = true;
  Moment now_{0};
  Moment busy_until_{0};  ///< The processor waits for the transmitter.
  std::int64_t bytes_overrun_ = 0;
};

}  // namespace slipstick
