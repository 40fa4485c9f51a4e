#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "tests/support/child_process.h"
#include "tests/support/temporary_folder.h"

struct mosquitto;

namespace slipstick::test {

/// Mosquitto on a port of 127.0.0.1 of its own.
class MqttBroker {
 public:
  /// \param user with `password` is the only one who may come in, if not empty.
  explicit MqttBroker(const std::string& user = "", const std::string& password = "");

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  void stop();
  /// On the same port; what was retained is forgotten.
  void start();

 private:
  TemporaryFolder folder_;
  std::uint16_t port_;
  std::unique_ptr<ChildProcess> process_;
};

/// A client of a broker that hears `topics` and says something.
class MqttClient {
 public:
  using Wanted = std::function<bool(std::string_view topic, std::string_view payload)>;

  MqttClient(const MqttBroker& broker, const std::string& topics, const std::string& user = "",
             const std::string& password = "");
  ~MqttClient();
  MqttClient(const MqttClient&) = delete;
  MqttClient& operator=(const MqttClient&) = delete;

  void say(const std::string& topic, const std::string& payload);
  /// Whether it hears such a message within a minute.
  [[nodiscard]] bool hears(const Wanted& wanted);
  [[nodiscard]] bool hears(std::string_view topic, std::string_view payload);

 private:
  mosquitto* client_;
  const Wanted* wanted_ = nullptr;
  bool heard_ = false;
};

}  // namespace slipstick::test
