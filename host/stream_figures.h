#pragma once

#include "drivers/marlin/sender_events.h"
#include "host/turnaround.h"

namespace slipstick {

/// What a stream of lines has come to so far.
struct StreamFigures {
  SenderCounters counters;
  Turnaround turnaround;
  double starved_seconds = 0;  ///< The printer wanted a line and there was none.
};

}  // namespace slipstick
