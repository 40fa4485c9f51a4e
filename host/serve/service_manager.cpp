#include "host/serve/service_manager.h"

#include <systemd/sd-daemon.h>

namespace slipstick {

void tell_manager_ready() {
  ::sd_notify(0, "READY=1");
}

void tell_manager_alive() {
  ::sd_notify(0, "WATCHDOG=1");
}

void tell_manager_stopping() {
  ::sd_notify(0, "STOPPING=1");
}

}  // namespace slipstick
