#pragma once

#include <memory>
#include <string_view>

#include "core/job/settings.h"
#include "drivers/clock.h"
#include "drivers/transport.h"
#include "drivers/transport_address.h"
#include "host/stream_job.h"
#include "sim/sim_transport.h"

namespace slipstick {

/// An open way to a printer: the one place that knows both real ports and the simulator.
struct PrinterLink {
  std::unique_ptr<Transport> transport;
  std::unique_ptr<Clock> own_clock;  ///< Of real ports.
  const Clock* clock = nullptr;
  Pace pace = Pace::kRealTime;
  SimTransport* sim = nullptr;  ///< `transport`, if that is the embedded simulator.
};

/// Opens what `address` names. \param sink gets every move of a simulated
/// printer.
[[nodiscard]] Result<PrinterLink> open_printer(const TransportAddress& address,
                                               const PrinterSettings& printer,
                                               const Planner::Sink& sink);

/// The simulated machine with the bed of `printer`: a delta where that is round.
[[nodiscard]] MachineOptions machine_like(const PrinterSettings& printer);

}  // namespace slipstick
