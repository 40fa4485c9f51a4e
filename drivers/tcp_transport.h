#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "drivers/transport.h"

namespace slipstick {

/// Connects to `host` (a name or a number) at `port`, without Nagle's delay.
///
/// Fails with kInput when the name does not resolve, kTimedOut when nobody answers within
/// `patience` (per address of the name), kUnavailable when nobody listens there. Resolving a name
/// may take as long as the system's resolver likes.
[[nodiscard]] Result<std::unique_ptr<Transport>> open_tcp(const std::string& host,
                                                          std::uint16_t port,
                                                          std::chrono::microseconds patience);

}  // namespace slipstick
