#include "tests/support/mqtt_broker.h"

#include <arpa/inet.h>
#include <mosquitto.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <chrono>
#include <fstream>

#include "core/base/check.h"
#include "drivers/unique_fd.h"
#include "tests/support/process.h"

namespace slipstick::test {
namespace {

using SteadyTime = std::chrono::steady_clock;
constexpr std::chrono::seconds kPatience{60};

sockaddr_in on_loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

// One that nobody has; a broker cannot say which one it was given.
std::uint16_t free_port() {
  const UniqueFd socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address = on_loopback(0);
  socklen_t size = sizeof address;
  auto* const raw = reinterpret_cast<sockaddr*>(&address);
  SLIPSTICK_CHECK(::bind(socket.get(), raw, size) == 0);
  SLIPSTICK_CHECK(::getsockname(socket.get(), raw, &size) == 0);
  return ntohs(address.sin_port);
}

bool answers(std::uint16_t port) {
  const UniqueFd socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const sockaddr_in address = on_loopback(port);
  return ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

}  // namespace

MqttBroker::MqttBroker(const std::string& user, const std::string& password) : port_(free_port()) {
  std::ofstream config(folder_.path() / "broker.conf");
  config << "listener " << port_ << " 127.0.0.1\n";
  config << "log_dest none\nuser root\n";  // if we are: another could not read our files
  if (user.empty()) {
    config << "allow_anonymous true\n";
  } else {
    const std::string file = (folder_.path() / "passwords").string();
    SLIPSTICK_CHECK(run({"/usr/bin/mosquitto_passwd", "-b", "-c", file, user, password}).status ==
                    0);
    config << "allow_anonymous false\npassword_file " << file << "\n";
  }
  config.close();
  start();
}

void MqttBroker::start() {
  process_ = std::make_unique<ChildProcess>(
      "/usr/sbin/mosquitto",
      std::vector<std::string>{"-c", (folder_.path() / "broker.conf").string()});
  const auto end = SteadyTime::now() + kPatience;
  while (!answers(port_)) SLIPSTICK_CHECK(SteadyTime::now() < end);
}

void MqttBroker::stop() {
  process_.reset();
}

MqttClient::MqttClient(const MqttBroker& broker, const std::string& topics, const std::string& user,
                       const std::string& password)
    : client_((mosquitto_lib_init(), mosquitto_new(nullptr, true, this))) {
  SLIPSTICK_CHECK(client_ != nullptr);
  mosquitto_message_callback_set(
      client_, [](mosquitto*, void* raw, const mosquitto_message* message) {
        auto& self = *static_cast<MqttClient*>(raw);
        const std::string_view payload(static_cast<const char*>(message->payload),
                                       static_cast<std::size_t>(message->payloadlen));
        if (self.wanted_ != nullptr && !self.heard_)
          self.heard_ = (*self.wanted_)(message->topic, payload);
      });
  if (!user.empty()) mosquitto_username_pw_set(client_, user.c_str(), password.c_str());
  SLIPSTICK_CHECK(mosquitto_connect(client_, "127.0.0.1", broker.port(), 60) == 0);
  SLIPSTICK_CHECK(mosquitto_subscribe(client_, nullptr, topics.c_str(), 1) == 0);
}

MqttClient::~MqttClient() {
  mosquitto_destroy(client_);
  mosquitto_lib_cleanup();
}

void MqttClient::say(const std::string& topic, const std::string& payload) {
  SLIPSTICK_CHECK(mosquitto_publish(client_, nullptr, topic.c_str(),
                                    static_cast<int>(payload.size()), payload.data(), 1,
                                    false) == 0);
}

bool MqttClient::hears(const Wanted& wanted) {
  wanted_ = &wanted;
  heard_ = false;
  const auto end = SteadyTime::now() + kPatience;
  while (!heard_ && SteadyTime::now() < end) {
    if (mosquitto_loop(client_, 100, 1) != MOSQ_ERR_SUCCESS) break;
  }
  wanted_ = nullptr;
  return heard_;
}

bool MqttClient::hears(std::string_view topic, std::string_view payload) {
  return hears([&](std::string_view t, std::string_view p) { return t == topic && p == payload; });
}

}  // namespace slipstick::test
