#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/clock.h"
#include "drivers/marlin/park.h"
#include "drivers/marlin/sender.h"
#include "drivers/transport.h"
#include "host/line_source.h"
#include "host/print_control.h"

namespace slipstick {

/// What to do while the next line is still being made.
enum class Pace {
  kRealTime,  ///< Keep serving the printer; the time counts as starved.
  kVirtual,   ///< Let time stand still: nothing happens while the host thinks.
};

struct StreamOptions {
  Pace pace = Pace::kRealTime;
  std::optional<ParkingPlace> parking{};  ///< Where the nozzle waits in a pause; else it stays.
  SenderOptions sender{};
  PrintStateTracker state{};  ///< What lines of the job before those of the source have left.
  int journal = -1;           ///< Descriptor of a journal, for last words.
  PrintControl::Listeners listeners{};  ///< Who hears of it beside those of the control.
  std::vector<Line> first{};            ///< Sent before the source's, and not counted.
  bool idle = false;  ///< There is no job: what would pause one is nobody's business.
};

struct StreamOutcome : StreamFigures {
  std::string firmware;
  std::uint64_t not_done = 0;  ///< Complaints of lines that were acknowledged and not obeyed,
  std::uint64_t unknown_commands = 0;  ///< and not known.
  double seconds = 0;                  ///< By the link's clock.
};

/// Sends all lines of `source` to the printer behind `transport` and waits until they were
/// accepted. One thread, one loop: bytes and time into the sender, bytes out.
///
/// What the printer itself asks for (`//action:pause`, `paused`, `resume`, `cancel`) is done as if
/// the control had asked. Where it acknowledges a line and says that it did not do it, the print is
/// paused, in virtual time, where nobody could look, ended; so it is where a sensor of a heater
/// that is to be hot cannot be right, and where the source wants it, before the line it wants it
/// for.
///
/// Whatever ends it early, the heaters are turned off if the printer can still hear it.
/// \return kCancelled if interrupted, kPrinter if the printer halted or was lost, kDisconnected if
/// `transport` went away, or what it or `source` failed with.
[[nodiscard]] Result<StreamOutcome> stream_job(Transport& transport, const Clock& clock,
                                               LineSource& source, const StreamOptions& options);

/// The same, and does what `control` is asked for within 20 ms, in virtual time a quarter of a
/// second; it pauses also while the terminal asks for it, and Ctrl-Z ends any pause. An emergency
/// stop goes out before all that has not left this machine; where the printer does not confirm it,
/// DTR resets the board. Interjections go out before the next line of the job, in pauses too.
[[nodiscard]] Result<StreamOutcome> stream_job(Transport& transport, const Clock& clock,
                                               LineSource& source, const StreamOptions& options,
                                               PrintControl& control);

}  // namespace slipstick
