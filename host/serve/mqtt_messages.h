#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "host/serve/event_log.h"

namespace slipstick {

/// \file
/// What is said to an MQTT broker of a printer, and what may be said back. Functions and values
/// without a connection.
///
/// Topics of the printer NAME: slipstick/NAME/availability ("online", "offline"), /state,
/// /progress and /temperatures (JSON as on the event stream), and, where commands are allowed,
/// /command. All but commands are retained, so that whoever comes later knows.

struct MqttMessage {
  std::string topic;
  std::string payload;

  friend bool operator==(const MqttMessage&, const MqttMessage&) = default;
};

enum class MqttCommands : std::uint8_t { kIgnored, kObeyed };

/// "slipstick/NAME/ENDING".
[[nodiscard]] std::string mqtt_topic(std::string_view name, std::string_view ending);

/// Home Assistant's discovery: one message for each thing that it then shows.
[[nodiscard]] std::vector<MqttMessage> mqtt_discovery(const std::string& name,
                                                      MqttCommands commands);

enum class PrinterCommand : std::uint8_t { kPause, kResume, kCancel, kEmergencyStop };

/// "pause", "resume", "cancel" or "emergency-stop". \return kInput for anything else.
[[nodiscard]] Result<PrinterCommand> parse_mqtt_command(std::string_view payload);

/// Thins out what changes many times a second: a state is said at once, progress and temperatures
/// at most once in `kInterval`, the latest of them.
class MqttPace {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kInterval{1};

  explicit MqttPace(std::string name) : name_(std::move(name)) {}

  /// \pre `due` is asked between any two logs of events, so that states do not pile up.
  void take(const EventLog::Event& event);
  /// What is to be said at `now`.
  [[nodiscard]] std::vector<MqttMessage> due(Time now);

 private:
  struct Stream {
    std::optional<std::string> waiting;
    std::optional<Time> said;
  };

  const std::string name_;
  std::vector<MqttMessage> states_;
  std::map<std::string, Stream, std::less<>> streams_{{"progress", {}}, {"temperatures", {}}};
};

}  // namespace slipstick
