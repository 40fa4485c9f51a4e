#include "drivers/open_transport.h"

#include "core/base/check.h"
#include "drivers/pty_transport.h"
#include "drivers/serial_ports.h"
#include "drivers/serial_transport.h"
#include "drivers/tcp_transport.h"

namespace slipstick {
namespace {

constexpr std::chrono::seconds kConnectPatience{10};

Result<std::unique_ptr<Transport>> open_at(const std::string& path,
                                           const TransportAddress& address) {
  const auto baud = baud_rate(address);
  if (!baud) return fail(baud.error());
  return open_serial(path, *baud);
}

Result<std::unique_ptr<Transport>> open_usb(const TransportAddress& address) {
  const auto ports = list_serial_ports();
  if (!ports) return fail(ports.error());
  const UsbId usb{address.vendor_id, address.product_id};
  const auto path = find_serial_port(*ports, usb, address.target);
  if (!path) return fail(path.error());
  return open_at(*path, address);
}

}  // namespace

Result<std::unique_ptr<Transport>> open_transport(const TransportAddress& address) {
  SLIPSTICK_CHECK(address.kind != TransportKind::kSim);
  switch (address.kind) {
    case TransportKind::kUsb:
      return open_usb(address);
    case TransportKind::kPty:
      return open_pty(address.target);
    case TransportKind::kTcp:
      return open_tcp(address.target, address.port, kConnectPatience);
    case TransportKind::kSerial:
    case TransportKind::kSim:
      break;
  }
  return open_at(address.target, address);
}

}  // namespace slipstick
