#pragma once

#include <functional>

#include "drivers/clock.h"
#include "drivers/transport.h"
#include "host/print_control.h"

namespace slipstick {

/// Keeps a printer company while nothing is printed: its temperatures are read, and what the
/// control is given is said. Until `ended()`, which is asked many times a second; then the heaters
/// stay as they are, and a printer that was not greeted yet is left at once. Cancelling the control
/// ends it with heaters and motors off.
/// \return as stream_job; kPrinter also for a printer that falls silent, within ten minutes.
[[nodiscard]] Result<void> stay_connected(Transport& transport, const Clock& clock,
                                          PrintControl& control,
                                          const std::function<bool()>& ended);

}  // namespace slipstick
