#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "drivers/serial_ports.h"

namespace slipstick {

/// What `slipstick ports --json` and the daemon tell of serial ports.
[[nodiscard]] nlohmann::ordered_json to_json(const std::vector<SerialPort>& ports);
/// "1a86:7523", or empty.
[[nodiscard]] std::string usb_text(const SerialPort& port);

}  // namespace slipstick
