#include "drivers/serial_ports.h"

#include <fmt/format.h>
#include <libserialport.h>

#include <algorithm>
#include <memory>

namespace slipstick {
namespace {

using PortList = std::unique_ptr<sp_port*, decltype(&::sp_free_port_list)>;

std::string text_or_empty(const char* text) {
  return text == nullptr ? "" : text;
}

SerialPort describe(const sp_port* port) {
  SerialPort described{.path = text_or_empty(::sp_get_port_name(port)),
                       .usb = std::nullopt,
                       .product = {},
                       .serial_number = {}};
  int vendor = 0;
  int product = 0;
  if (::sp_get_port_transport(port) != SP_TRANSPORT_USB) return described;
  described.product = text_or_empty(::sp_get_port_usb_product(port));
  described.serial_number = text_or_empty(::sp_get_port_usb_serial(port));
  if (::sp_get_port_usb_vid_pid(port, &vendor, &product) == SP_OK) {
    described.usb = {static_cast<std::uint16_t>(vendor), static_cast<std::uint16_t>(product)};
  }
  return described;
}

}  // namespace

Result<std::vector<SerialPort>> list_serial_ports() {
  sp_port** found = nullptr;
  if (::sp_list_ports(&found) != SP_OK) {
    return fail(ErrorCode::kUnavailable, "serial ports: the system does not list them");
  }
  const PortList list(found, &::sp_free_port_list);
  std::vector<SerialPort> ports;
  for (sp_port** port = found; *port != nullptr; ++port) ports.push_back(describe(*port));
  std::ranges::sort(ports, {}, &SerialPort::path);
  return ports;
}

Result<std::string> find_serial_port(const std::vector<SerialPort>& ports, UsbId usb,
                                     std::string_view serial_number) {
  const auto fits = [&](const SerialPort& port) {
    return port.usb == usb && (serial_number.empty() || port.serial_number == serial_number);
  };
  const std::string name = fmt::format("usb:{:04x}:{:04x}{}{}", usb.vendor, usb.product,
                                       serial_number.empty() ? "" : ":", serial_number);
  const auto count = std::ranges::count_if(ports, fits);
  if (count == 0) {
    return fail(ErrorCode::kUnavailable,
                name + ": no such adapter; is it plugged in and switched on?");
  }
  if (count > 1) {
    return fail(ErrorCode::kInput,
                fmt::format("{}: {} adapters have these ids; name one by its /dev path or add "
                            "its serial number",
                            name, count));
  }
  return std::ranges::find_if(ports, fits)->path;
}

}  // namespace slipstick
