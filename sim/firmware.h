#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "sim/auto_report.h"
#include "sim/emergency_parser.h"
#include "sim/executor.h"
#include "sim/line_gate.h"
#include "sim/line_reader.h"
#include "sim/machine.h"
#include "sim/meat_pack.h"
#include "sim/personality.h"
#include "sim/rx_ring.h"
#include "sim/thermal_guard.h"

namespace slipstick {

/// A firmware's main loop, Marlin's unless its personality says otherwise: receive buffer, line
/// check, command queue, ok, resend, busy, reports.
///
/// It runs in steps, each of which does what Marlin does between two prints: because printing
/// blocks the processor (no transmit buffer), the caller lets the text of one step go out over the
/// wire before the next one.
class Firmware {
 public:
  static constexpr Moment kBootTime{70'000};  ///< From power on to "start".

  static constexpr Moment kGuardPeriod{200'000};  ///< How often heaters are looked at.

  /// Starts at `power_on` because of `cause`.
  Firmware(Machine& machine, const Personality& personality, Moment power_on,
           ResetCause cause = ResetCause::kPowerUp);

  [[nodiscard]] RxRing& ring() { return ring_; }

  /// A byte arrives, whether or not the ring has room for it: an emergency parser looks at it.
  void notice(char byte);

  /// Does the next thing there is to do at `now`. \return Whether there was one.
  bool step(Moment now);

  /// What the last steps printed.
  [[nodiscard]] std::string take_text();

  /// When there may be something to do even if no byte comes and no move ends.
  [[nodiscard]] std::optional<Moment> wakes_at(Moment now) const;

  /// Whether it has said "start". Before, nobody hears what arrives.
  [[nodiscard]] bool booted() const { return booted_; }

  /// Whether received bytes would be read now.
  [[nodiscard]] bool reads() const {
    return booted_ && !machine_.halted && queue_.size() < personality_.queue_max;
  }

  /// Somebody presses the button at the printer.
  void press_button() { executor_.stop_waiting(); }

  /// Stops for good and says why: `reason`, whole lines, before the firmware's own last words.
  void kill(std::string_view reason);

  /// Numbered and unnumbered lines that entered the queue; Resend requests sent.
  [[nodiscard]] std::int64_t lines_accepted() const { return lines_accepted_; }
  [[nodiscard]] std::int64_t resends_requested() const { return resends_requested_; }

 private:
  struct Queued {
    std::string line;
    bool own = false;  ///< The firmware's own: it is not acknowledged.
  };

  bool boot(Moment now);
  /// Does what the emergency parser has found.
  bool obey_emergency(Moment now);
  /// Looks whether the filament has run out, and has it changed where it is to.
  bool watch_filament();
  bool read_lines(Moment now);
  void receive(std::string_view line, Moment now);
  void reject(Verdict verdict);
  void request_resend();
  /// What Marlin obeys when it reads it, not when its turn comes: M108, M112 and M410 at the start
  /// of a line.
  void obey_early(std::string_view line, Moment now);
  bool work(Moment now);
  /// Looks at the heaters and stops for good where one is broken.
  bool guard(Moment now);
  [[nodiscard]] bool has_to_guard() const;
  bool report(Moment now);
  /// Says "wait" where there was nothing to do for long.
  bool idle(Moment now);
  bool stay_busy(Moment now);
  bool run_command(Moment now);
  [[nodiscard]] bool has_work() const;
  void begin_command(Moment now);
  /// The line that acknowledges the command at the front.
  [[nodiscard]] std::string ok() const;
  /// Takes the next line of the file that the machine prints from its card. \return Whether it
  /// prints one.
  bool read_card();

  Machine& machine_;
  Personality personality_;
  Executor executor_;
  RxRing ring_;
  MeatPack meat_pack_;
  LineReader reader_;
  EmergencyParser emergency_parser_;
  std::optional<Emergency> emergency_;  ///< Found and not yet obeyed.
  LineGate gate_;
  ThermalGuard nozzle_guard_{nozzle_limits()};
  ThermalGuard bed_guard_{bed_limits()};
  std::deque<Queued> queue_;  ///< Its front is the command that runs or runs next.
  std::string text_;
  Moment boot_at_;
  ResetCause cause_;
  bool booted_ = false;
  bool ok_due_ = false;      ///< Whether the running command ends with "ok".
  bool ran_out_ = false;     ///< Whether that was said, and what has to be done is done.
  bool resending_ = false;   ///< The Error line is out, the flush and the Resend are due.
  Moment busy_at_{0};        ///< When to say "busy", while a command runs.
  Moment wait_at_{0};        ///< When to say "wait", if nothing happens before.
  Moment guard_at_{0};       ///< When to look at the heaters, if they are to be.
  AutoReport temperatures_;  ///< M155
  AutoReport positions_;     ///< M154
  std::int64_t lines_accepted_ = 0;
  std::int64_t resends_requested_ = 0;
};

}  // namespace slipstick
