// What is said to an MQTT broker, without one.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "host/serve/mqtt_address.h"
#include "host/serve/mqtt_messages.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

constexpr MqttPace::Time kStart{};

EventLog::Event event(const char* type, const char* data) {
  return {1, type, data};
}

std::string topics(const std::vector<MqttMessage>& messages) {
  std::string text;
  for (const MqttMessage& message : messages)
    text += message.topic.substr(message.topic.rfind('/') + 1) + "=" + message.payload + " ";
  return text;
}

}  // namespace

TEST_CASE("An address of a broker has a host, maybe a port and a user, and no password") {
  const auto plain = parse_mqtt_address("mqtt://broker.local");
  REQUIRE(plain);
  CHECK(plain->host == "broker.local");
  CHECK(plain->port == 1883);
  CHECK_FALSE(plain->tls);
  CHECK(plain->user.empty());
  const auto full = parse_mqtt_address("mqtts://pi@10.0.0.2:9001");
  REQUIRE(full);
  CHECK(full->host == "10.0.0.2");
  CHECK(full->port == 9001);
  CHECK(full->tls);
  CHECK(full->user == "pi");
  CHECK(parse_mqtt_address("mqtts://b")->port == 8883);

  for (const char* text :
       {"", "broker", "http://broker", "mqtt://", "mqtt://@broker", "mqtt://b:", "mqtt://b:0",
        "mqtt://b:65536", "mqtt://b:1x", "mqtt://b/c", "mqtt://:1", "mqtt://a b"}) {
    INFO(text);
    const auto address = parse_mqtt_address(text);
    REQUIRE_FALSE(address);
    CHECK_THAT(address.error().message, Contains("mqtt://[USER@]HOST[:PORT]"));
  }
  CHECK_THAT(parse_mqtt_address("mqtt://pi:secret@b").error().message,
             Contains("--mqtt-password-file") && !Contains("secret"));
}

TEST_CASE("A name in topics cannot reach beyond its own") {
  CHECK(parse_mqtt_name("Ender-3_b") == "Ender-3_b");
  CHECK(parse_mqtt_name(default_mqtt_name()));
  for (const char* name : {"", "a/b", "#", "+", "a b", "ü"}) CHECK_FALSE(parse_mqtt_name(name));
  CHECK_FALSE(parse_mqtt_name(std::string(65, 'a')));
}

TEST_CASE("States are said at once, what changes often at most once a second, the latest of it") {
  MqttPace pace("pi");
  pace.take(event("temperatures", "1"));
  pace.take(event("temperatures", "2"));
  CHECK(pace.due(kStart).front() == MqttMessage{"slipstick/pi/temperatures", "2"});

  pace.take(event("temperatures", "3"));
  pace.take(event("log", "nothing for a broker"));
  CHECK(pace.due(kStart + std::chrono::milliseconds(999)).empty());
  CHECK(topics(pace.due(kStart + std::chrono::milliseconds(1000))) == "temperatures=3 ");
  CHECK(pace.due(kStart + std::chrono::seconds(9)).empty());

  pace.take(event("progress", "4"));
  CHECK(topics(pace.due(kStart)) == "progress=4 ");
  pace.take(event("state", "5"));
  pace.take(event("state", "6"));
  CHECK(topics(pace.due(kStart)) == "state=5 state=6 ");
  CHECK(topics(pace.due(kStart + MqttPace::kInterval)) == "progress=6 ");
}

TEST_CASE(
    "Home Assistant is told of each thing once, and of buttons only where they do something") {
  for (const auto commands : {MqttCommands::kIgnored, MqttCommands::kObeyed}) {
    std::set<std::string> ids, seen;
    int buttons = 0;
    for (const MqttMessage& message : mqtt_discovery("pi", commands)) {
      INFO(message.topic);
      CHECK(seen.insert(message.topic).second);
      CHECK(message.topic.ends_with("/config"));
      const auto said = json::parse(message.payload);
      CHECK(ids.insert(said["unique_id"]).second);
      CHECK(said["availability_topic"] == "slipstick/pi/availability");
      if (message.topic.starts_with("homeassistant/sensor/slipstick_pi/")) {
        CHECK(said["state_topic"].get<std::string>().starts_with("slipstick/pi/"));
      } else {
        REQUIRE(message.topic.starts_with("homeassistant/button/slipstick_pi/"));
        ++buttons;
        CHECK(said["command_topic"] == "slipstick/pi/command");
        CHECK(parse_mqtt_command(said["payload_press"].get<std::string>()));
      }
    }
    CHECK(buttons == (commands == MqttCommands::kObeyed ? 4 : 0));
  }
}

TEST_CASE("Nothing but a command is a command") {
  CHECK(parse_mqtt_command("emergency-stop") == PrinterCommand::kEmergencyStop);
  for (const char* payload : {"", "Pause", "pause ", "M112", "emergency-stopemergency-stop"})
    CHECK_FALSE(parse_mqtt_command(payload));
}
