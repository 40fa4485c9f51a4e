#pragma once

#include <memory>

#include "drivers/transport.h"
#include "drivers/transport_address.h"

namespace slipstick {

/// Opens what `address` names: every kind but kSim, which only the host can wire.
/// Fails as the function for the kind does; a USB address also as `find_serial_port` does.
/// \pre the kind is not kSim.
[[nodiscard]] Result<std::unique_ptr<Transport>> open_transport(const TransportAddress& address);

}  // namespace slipstick
