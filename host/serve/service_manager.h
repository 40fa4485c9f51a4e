#pragma once

namespace slipstick {

/// \file
/// What a service tells systemd (sd_notify(3)); nothing where there is none.

void tell_manager_ready();
/// Often enough for `WatchdogSec=`.
void tell_manager_alive();
void tell_manager_stopping();

}  // namespace slipstick
