#include "host/serve/mqtt_messages.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<std::string_view, PrinterCommand>, 4> kCommands{
    {{"pause", PrinterCommand::kPause},
     {"resume", PrinterCommand::kResume},
     {"cancel", PrinterCommand::kCancel},
     {"emergency-stop", PrinterCommand::kEmergencyStop}}};

struct Sensor {
  const char* id;
  const char* name;
  const char* topic;
  const char* value;
  const char* unit;
  const char* device_class;
};

constexpr std::array<Sensor, 7> kSensors{{
    {"state", "State", "state", "{{ value_json.state }}", "", ""},
    {"file", "File", "state", "{{ value_json.job.file if value_json.job else '' }}", "", ""},
    {"completion", "Completion", "progress",
     "{{ (value_json.job.completion * 100) | round(1) if value_json.job else 0 }}", "%", ""},
    {"layer", "Layer", "progress", "{{ value_json.job.layer if value_json.job else 0 }}", "", ""},
    {"seconds", "Time printing", "progress",
     "{{ value_json.job.seconds | round(0) if value_json.job else 0 }}", "s", "duration"},
    {"nozzle", "Nozzle", "temperatures", "{{ value_json.nozzle.actual }}", "°C", "temperature"},
    {"bed", "Bed", "temperatures", "{{ value_json.bed.actual }}", "°C", "temperature"},
}};

Json common(const std::string& name, std::string_view id, std::string_view shown) {
  return {{"name", shown},
          {"unique_id", fmt::format("slipstick_{}_{}", name, id)},
          {"object_id", fmt::format("slipstick_{}_{}", name, id)},
          {"availability_topic", mqtt_topic(name, "availability")},
          {"device",
           {{"identifiers", {fmt::format("slipstick_{}", name)}},
            {"name", name},
            {"manufacturer", "slipstick"},
            {"sw_version", SLIPSTICK_VERSION}}}};
}

MqttMessage config(std::string_view component, const std::string& name, std::string_view id,
                   const Json& json) {
  return {fmt::format("homeassistant/{}/slipstick_{}/{}/config", component, name, id), json.dump()};
}

MqttMessage sensor_config(const std::string& name, const Sensor& sensor) {
  Json json = common(name, sensor.id, sensor.name);
  json["state_topic"] = mqtt_topic(name, sensor.topic);
  json["value_template"] = sensor.value;
  if (*sensor.unit != '\0') json["unit_of_measurement"] = sensor.unit;
  if (*sensor.device_class != '\0') json["device_class"] = sensor.device_class;
  return config("sensor", name, sensor.id, json);
}

MqttMessage button_config(const std::string& name, std::string_view command) {
  std::string shown(command);
  shown.front() = static_cast<char>(shown.front() - 'a' + 'A');
  Json json = common(name, command, shown);
  json["command_topic"] = mqtt_topic(name, "command");
  json["payload_press"] = command;
  return config("button", name, command, json);
}

}  // namespace

std::string mqtt_topic(std::string_view name, std::string_view ending) {
  return fmt::format("slipstick/{}/{}", name, ending);
}

std::vector<MqttMessage> mqtt_discovery(const std::string& name, MqttCommands commands) {
  std::vector<MqttMessage> messages;
  messages.reserve(kSensors.size() + kCommands.size());
  for (const Sensor& sensor : kSensors) messages.push_back(sensor_config(name, sensor));
  if (commands == MqttCommands::kIgnored) return messages;
  for (const auto& command : kCommands) messages.push_back(button_config(name, command.first));
  return messages;
}

Result<PrinterCommand> parse_mqtt_command(std::string_view payload) {
  for (const auto& [name, command] : kCommands) {
    if (name == payload) return command;
  }
  return fail(ErrorCode::kInput, "a command is pause, resume, cancel or emergency-stop");
}

void MqttPace::take(const EventLog::Event& event) {
  const bool is_state = event.type == "state";
  if (is_state) states_.push_back({mqtt_topic(name_, "state"), event.data});
  // Both have one shape; without it the progress of a job that is over would stand there for good.
  const auto stream = streams_.find(is_state ? "progress" : event.type);
  if (stream != streams_.end()) stream->second.waiting = event.data;
}

std::vector<MqttMessage> MqttPace::due(Time now) {
  std::vector<MqttMessage> messages = std::exchange(states_, {});
  for (auto& [type, stream] : streams_) {
    if (!stream.waiting || (stream.said && now - *stream.said < kInterval)) continue;
    messages.push_back({mqtt_topic(name_, type), *std::exchange(stream.waiting, {})});
    stream.said = now;
  }
  return messages;
}

}  // namespace slipstick
