#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// What kind of thing a printer's address names.
enum class TransportKind : std::uint8_t {
  kSerial,  ///< `/dev/ttyUSB0[?baud=250000]`
  kUsb,     ///< `usb:VID:PID[:SERIAL]`, a serial port found by its adapter's ids
  kPty,     ///< `pty:PATH`
  kTcp,     ///< `tcp:HOST:PORT`
  kSim,     ///< `sim:[?key=value&...]`, resolved by whoever knows the simulator
};

/// A parsed printer's address: where the bytes go.
struct TransportAddress {
  TransportKind kind = TransportKind::kSerial;
  /// A path (kSerial, kPty), a host (kTcp), a serial number or nothing (kUsb), nothing (kSim).
  std::string target;
  std::uint16_t port = 0;                                   ///< kTcp only.
  std::uint16_t vendor_id = 0;                              ///< kUsb only.
  std::uint16_t product_id = 0;                             ///< kUsb only.
  std::map<std::string, std::string, std::less<>> options;  ///< What stood behind `?`.

  friend bool operator==(const TransportAddress&, const TransportAddress&) = default;
};

/// Fails (kInput) with a message that says which part is wrong and shows the right form.
/// Serial kinds accept the option `baud` only, pty and tcp none; those of sim are not looked at.
[[nodiscard]] Result<TransportAddress> parse_transport_address(std::string_view text);

/// The baud rate of a serial address; 115200 when it names none.
/// Fails (kInput) unless it is a whole number from 1200 to 4,000,000.
[[nodiscard]] Result<int> baud_rate(const TransportAddress& address);

}  // namespace slipstick
