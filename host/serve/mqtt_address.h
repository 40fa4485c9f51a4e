#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// Where an MQTT broker is: "mqtt://HOST", "mqtts://USER@HOST:PORT" (TLS, by the system's
/// certificates). Passwords do not stand in addresses: everybody on the machine can read those.
struct MqttAddress {
  std::string host;
  std::uint16_t port = 0;
  bool tls = false;
  std::string user;  ///< Empty: nobody in particular.
};

/// \return kInput, saying what is wrong with it.
[[nodiscard]] Result<MqttAddress> parse_mqtt_address(std::string_view text);

/// The name of a printer in topics: 1 to 64 of a-z, A-Z, 0-9, "-" and "_".
[[nodiscard]] Result<std::string> parse_mqtt_name(std::string_view text);

/// The name of this machine, with "_" for what a name cannot have.
[[nodiscard]] std::string default_mqtt_name();

}  // namespace slipstick
