#include "host/serve/mqtt_bridge.h"

#include <fmt/format.h>
#include <mosquitto.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

namespace slipstick {
namespace {

using SteadyTime = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kKeepAliveSeconds = 30;
/// How long news may wait for a turn of the loop.
constexpr milliseconds kTurn{100};
constexpr std::chrono::seconds kBetweenConnections{5};
/// For the last word.
constexpr int kLastTurns = 10;
constexpr std::size_t kCommandBytesMax = 64;
constexpr const char* kCertificates = "/etc/ssl/certs";
constexpr int kAtMostOnce = 0, kAtLeastOnce = 1;

// The library counts its users.
class MosquittoLibrary {
 public:
  MosquittoLibrary() { mosquitto_lib_init(); }
  ~MosquittoLibrary() { mosquitto_lib_cleanup(); }
  MosquittoLibrary(const MosquittoLibrary&) = delete;
  MosquittoLibrary& operator=(const MosquittoLibrary&) = delete;
};

struct Destroy {
  void operator()(mosquitto* client) const { mosquitto_destroy(client); }
};

int size_of(const std::string& text) {
  return static_cast<int>(text.size());
}

}  // namespace

class MqttBridge::Implementation {
 public:
  Implementation(Options options, const EventLog& events, const StatusBoard& board, Obey obey)
      : options_(std::move(options)),
        events_(events),
        board_(board),
        obey_(std::move(obey)),
        pace_(options_.name) {}

  ~Implementation() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    stop_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

  Result<void> start() {
    client_.reset(mosquitto_new(nullptr, true, this));
    if (!client_) return refused("no client", MOSQ_ERR_NOMEM);
    const std::string& user = options_.address.user;
    if (!user.empty()) {
      const int set =
          mosquitto_username_pw_set(client_.get(), user.c_str(), options_.password.c_str());
      if (set != MOSQ_ERR_SUCCESS) return refused("the user", set);
    }
    if (options_.address.tls) {
      const int set =
          mosquitto_tls_set(client_.get(), nullptr, kCertificates, nullptr, nullptr, nullptr);
      if (set != MOSQ_ERR_SUCCESS) return refused("TLS", set);
    }
    const std::string topic = mqtt_topic(options_.name, "availability");
    constexpr std::string_view kOffline = "offline";
    const int set = mosquitto_will_set(client_.get(), topic.c_str(), int{kOffline.size()},
                                       kOffline.data(), kAtLeastOnce, true);
    if (set != MOSQ_ERR_SUCCESS) return refused("the last will", set);
    mosquitto_connect_callback_set(client_.get(), [](mosquitto*, void* self, int why_not) {
      static_cast<Implementation*>(self)->on_connected(why_not);
    });
    mosquitto_message_callback_set(client_.get(),
                                   [](mosquitto*, void* self, const mosquitto_message* message) {
                                     static_cast<Implementation*>(self)->on_message(*message);
                                   });
    seen_ = events_.last();
    thread_ = std::thread([this] { run(); });
    return {};
  }

 private:
  static tl::unexpected<Error> refused(std::string_view what, int error) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("MQTT, {}: {}", what, mosquitto_strerror(error)));
  }

  void run() {
    while (!is_stopping()) {
      connect_if_due();
      tell_news();
      turn();
    }
    if (!connected_) return;
    say({mqtt_topic(options_.name, "availability"), "offline"}, kAtLeastOnce);
    for (int i = 0; i < kLastTurns && mosquitto_want_write(client_.get()); ++i) turn();
    mosquitto_disconnect(client_.get());
    turn();
  }

  bool is_stopping() {
    const std::lock_guard lock(mutex_);
    return stopping_;
  }

  void connect_if_due() {
    if (tried_ && (under_way_ || SteadyTime::now() - *tried_ < kBetweenConnections)) return;
    const MqttAddress& to = options_.address;
    // Without waiting for it; only the name is looked up here.
    const int begun =
        mosquitto_connect_async(client_.get(), to.host.c_str(), to.port, kKeepAliveSeconds);
    tried_ = SteadyTime::now();
    under_way_ = begun == MOSQ_ERR_SUCCESS;
    if (!under_way_) complain(begun);
  }

  void turn() {
    if (under_way_) {
      const int ended = mosquitto_loop(client_.get(), int{kTurn.count()}, 1);
      if (ended == MOSQ_ERR_SUCCESS) return;
      under_way_ = false;
      connected_ = false;
      complain(ended);
      return;
    }
    std::unique_lock lock(mutex_);
    stop_.wait_for(lock, kTurn, [this] { return stopping_; });
  }

  // Once for every time that it is lost, not for every try.
  void complain(int error) {
    if (std::exchange(complained_, true)) return;
    spdlog::warn("MQTT broker {}:{}: {}; trying again every {} s", options_.address.host,
                 options_.address.port, mosquitto_strerror(error), kBetweenConnections.count());
  }

  void on_connected(int why_not) {
    if (why_not != 0) {
      if (std::exchange(complained_, true)) return;
      spdlog::warn("MQTT broker {}:{}: {}", options_.address.host, options_.address.port,
                   mosquitto_connack_string(why_not));
      return;
    }
    complained_ = false;
    connected_ = true;
    spdlog::info("MQTT broker {}:{} is told as {}", options_.address.host, options_.address.port,
                 options_.name);
    for (const MqttMessage& message : mqtt_discovery(options_.name, options_.commands))
      say(message, kAtMostOnce);
    say({mqtt_topic(options_.name, "state"), state_text()}, kAtMostOnce);
    say({mqtt_topic(options_.name, "availability"), "online"}, kAtMostOnce);
    if (options_.commands == MqttCommands::kIgnored) return;
    const std::string topic = mqtt_topic(options_.name, "command");
    mosquitto_subscribe(client_.get(), nullptr, topic.c_str(), kAtLeastOnce);
  }

  // A printer may have said what is no UTF-8.
  [[nodiscard]] std::string state_text() const {
    return to_json(board_.get())
        .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }

  // A retained command is one of long ago: it would be obeyed at every start.
  void on_message(const mosquitto_message& message) {
    if (message.retain || message.payloadlen < 0) return;
    const auto size = static_cast<std::size_t>(message.payloadlen);
    const std::string_view payload(static_cast<const char*>(message.payload),
                                   std::min(size, kCommandBytesMax));
    const auto command = parse_mqtt_command(payload);
    const auto obeyed = command ? obey_(*command) : Result<void>(fail(command.error()));
    if (!obeyed) spdlog::warn("MQTT command: {}", obeyed.error().message);
  }

  void tell_news() {
    const EventLog::News news = events_.since(seen_);
    for (const EventLog::Event& event : news.events) pace_.take(event);
    if (!news.events.empty()) seen_ = news.events.back().number;
    for (const MqttMessage& message : pace_.due(SteadyTime::now())) say(message, kAtMostOnce);
  }

  // What cannot be said now is not kept: the next connection begins with how things are then.
  void say(const MqttMessage& message, int quality) {
    if (!connected_) return;
    mosquitto_publish(client_.get(), nullptr, message.topic.c_str(), size_of(message.payload),
                      message.payload.data(), quality, true);
  }

  const Options options_;
  const EventLog& events_;
  const StatusBoard& board_;
  const Obey obey_;

  // The thread's own, callbacks included: the library calls them from its loop.
  const MosquittoLibrary library_;
  std::unique_ptr<mosquitto, Destroy> client_;
  MqttPace pace_;
  std::int64_t seen_ = 0;
  std::optional<SteadyTime::time_point> tried_;
  bool under_way_ = false;
  bool connected_ = false;
  bool complained_ = false;

  std::mutex mutex_;  ///< Protects what follows.
  std::condition_variable stop_;
  bool stopping_ = false;

  std::thread thread_;  // last: it uses what stands above
};

MqttBridge::MqttBridge(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

MqttBridge::~MqttBridge() = default;

Result<std::unique_ptr<MqttBridge>> MqttBridge::start(Options options, const EventLog& events,
                                                      const StatusBoard& board, Obey obey) {
  auto implementation =
      std::make_unique<Implementation>(std::move(options), events, board, std::move(obey));
  if (const auto ok = implementation->start(); !ok) return fail(ok.error());
  return std::unique_ptr<MqttBridge>(new MqttBridge(std::move(implementation)));
}

}  // namespace slipstick
