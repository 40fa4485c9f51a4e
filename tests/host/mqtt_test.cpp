// The daemon and a real broker, Mosquitto.
#include <signal.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/http_client.h"
#include "tests/support/mqtt_broker.h"

using namespace slipstick;
using nlohmann::json;

namespace {

// `slipstick serve` that tells a broker.
class ToldDaemon {
 public:
  ToldDaemon(const std::string& broker, const std::string& name, std::vector<std::string> more = {})
      : process_(words(broker, name, std::move(more))) {
    const std::string line = process_.line();
    REQUIRE(line.find("listening on ") == 0);
    port_ = static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
  }

  void print(const std::string& program) const {
    REQUIRE(test::request(port_, "PUT", "/api/v1/files/a.gcode", program).status == 201);
    REQUIRE(test::request(port_, "POST", "/api/v1/jobs", R"({"file": "a.gcode"})").status == 201);
  }
  [[nodiscard]] std::string job_state() const {
    const auto reply = test::request(port_, "GET", "/api/v1/jobs/1");
    return json::parse(reply.body)["state"];
  }
  int end(int signal) {
    process_.send(signal);
    return process_.wait();
  }

 private:
  std::vector<std::string> words(const std::string& broker, const std::string& name,
                                 std::vector<std::string> more) const {
    std::vector<std::string> words{
        "serve", "--data", folder_.path().string(), "--listen",    "127.0.0.1:0", "--printer",
        "sim:",  "--mqtt", "mqtt://" + broker,      "--mqtt-name", name};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  test::TemporaryFolder folder_;
  test::ChildProcess process_;
  std::uint16_t port_ = 0;
};

std::string long_program() {
  std::string program = "M104 S210\n";
  for (int i = 0; i < 400'000; ++i) program += "G1 X" + std::to_string(i % 9) + " F3000\n";
  return program;
}

auto state_is(const std::string& wanted) {
  return [wanted](std::string_view topic, std::string_view payload) {
    return topic.ends_with("/state") && json::parse(payload)["state"] == wanted;
  };
}

}  // namespace

TEST_CASE("Three printers are seen through one broker, and one of them is paused and cancelled") {
  const test::MqttBroker broker;
  test::MqttClient fleet(broker, "slipstick/+/+");
  const ToldDaemon first(broker.address(), "one", {"--mqtt-commands"});
  const ToldDaemon second(broker.address(), "two", {"--mqtt-commands"});
  const ToldDaemon third(broker.address(), "three");
  std::set<std::string, std::less<>> online;
  REQUIRE(fleet.hears([&](std::string_view topic, std::string_view payload) {
    if (payload == "online") online.emplace(topic);
    return online.size() == 3;
  }));

  second.print(long_program());
  REQUIRE(fleet.hears([](std::string_view topic, std::string_view payload) {
    return topic == "slipstick/two/progress" && json::parse(payload)["job"].is_object() &&
           json::parse(payload)["job"]["lines"] > 0;
  }));
  REQUIRE(fleet.hears([](std::string_view topic, std::string_view payload) {
    return topic == "slipstick/two/temperatures" && json::parse(payload)["nozzle"]["target"] == 210;
  }));
  fleet.say("slipstick/two/command", "pause");
  CHECK(fleet.hears(state_is("paused")));
  fleet.say("slipstick/two/command", "nonsense");
  fleet.say("slipstick/two/command", "resume");
  CHECK(fleet.hears(state_is("printing")));
  fleet.say("slipstick/two/command", "cancel");
  CHECK(fleet.hears(state_is("idle")));
  CHECK(second.job_state() == "cancelled");
}

TEST_CASE("Without leave to command, nothing that a broker says is obeyed") {
  const test::MqttBroker broker;
  test::MqttClient listener(broker, "slipstick/pi/+");
  ToldDaemon daemon(broker.address(), "pi");
  REQUIRE(listener.hears("slipstick/pi/availability", "online"));
  daemon.print("G1 X1 F600\nG4 S1\n" + long_program());
  REQUIRE(listener.hears(state_is("printing")));

  listener.say("slipstick/pi/command", "cancel");

  CHECK(listener.hears(state_is("idle")));
  CHECK(daemon.job_state() == "done");
}

TEST_CASE("Who comes later knows how things are, also of a printer that vanished") {
  const test::MqttBroker broker;
  test::MqttClient early(broker, "slipstick/#");
  ToldDaemon daemon(broker.address(), "pi");
  REQUIRE(early.hears("slipstick/pi/availability", "online"));

  test::MqttClient late(broker, "slipstick/#");
  CHECK(late.hears("slipstick/pi/availability", "online"));
  test::MqttClient home(broker, "homeassistant/#");
  CHECK(home.hears([](std::string_view topic, std::string_view) {
    return topic == "homeassistant/sensor/slipstick_pi/state/config";
  }));

  daemon.end(SIGKILL);
  CHECK(early.hears("slipstick/pi/availability", "offline"));
  ToldDaemon again(broker.address(), "pi");
  REQUIRE(early.hears("slipstick/pi/availability", "online"));
  CHECK(again.end(SIGTERM) == 0);
  CHECK(early.hears("slipstick/pi/availability", "offline"));
}

TEST_CASE("A broker that comes later, or again, is told then") {
  test::MqttBroker broker;
  broker.stop();
  ToldDaemon daemon(broker.address(), "pi");

  for (int i = 0; i < 2; ++i) {
    broker.start();
    test::MqttClient listener(broker, "slipstick/#");
    CHECK(listener.hears("slipstick/pi/availability", "online"));
    broker.stop();
  }
  CHECK(daemon.end(SIGTERM) == 0);
}

TEST_CASE("The password of a broker comes from a file") {
  const test::MqttBroker broker("pi", "secret words");
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "password").string();
  std::ofstream(file) << "secret words\n";
  test::MqttClient listener(broker, "slipstick/#", "pi", "secret words");

  ToldDaemon daemon("pi@" + broker.address(), "pi", {"--mqtt-password-file", file});

  CHECK(listener.hears("slipstick/pi/availability", "online"));
}
