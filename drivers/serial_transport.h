#pragma once

#include <memory>
#include <string>

#include "drivers/transport.h"

namespace slipstick {

/// Opens the serial port at `path` for us alone: 8 data bits, no parity, 1 stop bit, no flow
/// control, any `baud` the adapter can do (250000 too). Many boards reset when DTR rises, which is
/// at the first opening after plugging in: closing leaves it up.
///
/// Fails (kUnavailable) when it is absent, in use, not permitted, or refuses the settings.
[[nodiscard]] Result<std::unique_ptr<Transport>> open_serial(const std::string& path, int baud);

}  // namespace slipstick
