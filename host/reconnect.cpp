#include "host/reconnect.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "drivers/open_transport.h"

namespace slipstick {
namespace {

bool same_device(const SerialPort& a, const SerialPort& b) {
  return a.usb == b.usb && a.serial_number == b.serial_number;
}

}  // namespace

TransportAddress lasting_address(const TransportAddress& address,
                                 const std::vector<SerialPort>& ports) {
  if (address.kind != TransportKind::kSerial) return address;
  const auto port = std::ranges::find(ports, address.target, &SerialPort::path);
  if (port == ports.end() || !port->usb || port->serial_number.empty()) return address;
  const auto twins = std::ranges::count_if(
      ports, [&](const SerialPort& other) { return same_device(*port, other); });
  if (twins != 1) return address;
  TransportAddress lasting = address;
  lasting.kind = TransportKind::kUsb;
  lasting.target = port->serial_number;
  lasting.vendor_id = port->usb->vendor;
  lasting.product_id = port->usb->product;
  return lasting;
}

const TransportAddress& ReturningPort::address() {
  // Of the ports as they are now: once it is gone, nobody can tell what it was.
  if (const auto ports = list_serial_ports()) address_ = lasting_address(address_, *ports);
  return address_;
}

Error ReturningPort::met(Error error) const {
  if (returns_ > 0 && error.code == ErrorCode::kUnavailable) error.code = ErrorCode::kDisconnected;
  return error;
}

bool ReturningPort::lost(const Error& error) const {
  if (address_.kind == TransportKind::kSim || returns_ == kReturnsMax) return false;
  return error.code == ErrorCode::kDisconnected;
}

bool ReturningPort::comes_back() {
  const SteadyClock clock;
  const Moment until = clock.now() + waiting_.patience;
  waiting_.tell(
      fmt::format("the printer's port is gone; if it is back within {} minutes, the print goes on",
                  std::chrono::duration_cast<std::chrono::minutes>(waiting_.patience).count()));
  while (clock.now() < until && !waiting_.ended()) {
    std::this_thread::sleep_for(waiting_.between_looks);
    if (!open_transport(address_)) continue;
    ++returns_;
    waiting_.tell("the printer's port is back");
    return true;
  }
  return false;
}

}  // namespace slipstick
