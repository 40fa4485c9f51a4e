#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace slipstick {

/// The ids of the USB adapter behind a serial port.
struct UsbId {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;

  friend bool operator==(const UsbId&, const UsbId&) = default;
};

/// A serial port of this machine, as the system describes it; texts are empty when it does not.
struct SerialPort {
  std::string path;
  std::optional<UsbId> usb;
  std::string product;
  std::string serial_number;

  friend bool operator==(const SerialPort&, const SerialPort&) = default;
};

/// All serial ports, sorted by path; opens none of them. Fails (kUnavailable) when the system does
/// not tell.
[[nodiscard]] Result<std::vector<SerialPort>> list_serial_ports();

/// The path of the one port among `ports` with these ids, and this serial number unless it is
/// empty. Fails (kUnavailable) when there is none, and (kInput) when there are several: a wrong
/// guess would start the wrong printer.
[[nodiscard]] Result<std::string> find_serial_port(const std::vector<SerialPort>& ports, UsbId usb,
                                                   std::string_view serial_number);

}  // namespace slipstick
