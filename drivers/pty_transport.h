#pragma once

#include <memory>
#include <string>

#include "drivers/transport.h"

namespace slipstick {

/// Opens the terminal at `path` (a pseudo-terminal, as a simulated printer offers one) as raw
/// bytes: no echo, no translation, no job control.
///
/// Fails (kUnavailable) when it is absent, not permitted, or not a terminal.
[[nodiscard]] Result<std::unique_ptr<Transport>> open_pty(const std::string& path);

}  // namespace slipstick
