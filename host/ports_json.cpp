#include "host/ports_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace slipstick {

std::string usb_text(const SerialPort& port) {
  return port.usb ? fmt::format("{:04x}:{:04x}", port.usb->vendor, port.usb->product) : "";
}

nlohmann::ordered_json to_json(const std::vector<SerialPort>& ports) {
  auto json = nlohmann::ordered_json::array();
  for (const SerialPort& port : ports) {
    json.push_back({{"path", port.path},
                    {"usb", usb_text(port)},
                    {"product", port.product},
                    {"serial", port.serial_number}});
  }
  return json;
}

}  // namespace slipstick
