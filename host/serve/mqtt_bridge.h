#pragma once

#include <functional>
#include <memory>
#include <string>

#include "host/serve/mqtt_address.h"
#include "host/serve/mqtt_messages.h"
#include "host/serve/printer_status.h"

namespace slipstick {

/// Tells an MQTT broker of a printer, on a thread of its own, by libmosquitto. Where the broker is
/// not there, or goes away, it is tried again; nothing is kept for it but the latest of everything,
/// and the printer never waits for it. The broker itself says "offline" where we vanish.
class MqttBridge {
 public:
  struct Options {
    MqttAddress address;
    std::string password;
    std::string name;
    MqttCommands commands = MqttCommands::kIgnored;
  };
  /// Carries out a command. \return why not.
  using Obey = std::function<Result<void>(PrinterCommand)>;

  /// Begins; whether the broker is there is seen later, and logged.
  /// \return kUnavailable if the library does not want to.
  [[nodiscard]] static Result<std::unique_ptr<MqttBridge>> start(Options options,
                                                                 const EventLog& events,
                                                                 const StatusBoard& board,
                                                                 Obey obey);
  /// Says "offline" and ends, within a second or two if the broker is there; at most as long as the
  /// system takes to look up a name where it is not.
  ~MqttBridge();
  MqttBridge(const MqttBridge&) = delete;
  MqttBridge& operator=(const MqttBridge&) = delete;

 private:
  class Implementation;
  explicit MqttBridge(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace slipstick
