#pragma once

#include <optional>

#include "host/serve/app_requests.h"
#include "host/serve/login_limiter.h"
#include "host/serve/setup_code.h"

namespace slipstick {

/// What is asked where somebody shows a password or the code of the set-up, and who asks for a key.
/// Threads: that of slow routes; whether there is a code never changes, and is for all.
struct LoginDesk {
  const std::optional<SetupCode> setup;  ///< Nothing: the first account needs none.
  LoginLimiter limiter = {};
  AppRequests apps = {};
};

}  // namespace slipstick
