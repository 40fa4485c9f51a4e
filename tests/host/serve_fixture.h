#pragma once

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <thread>

#include "host/serve/daemon.h"
#include "tests/support/http_client.h"
#include "tests/support/temporary_folder.h"

namespace slipstick::test {

/// A daemon with a simulated printer, in this process, on a port of its own.
class RunningDaemon {
 public:
  explicit RunningDaemon(std::string printer = "sim:", std::string listen = "127.0.0.1:0",
                         const HttpLimits& limits = {}, std::string camera = {})
      : limits_(limits), camera_(std::move(camera)) {
    start(std::move(printer), std::move(listen));
  }
  ~RunningDaemon() { stop(); }

  void stop() {
    goes_on_ = false;
    if (thread_.joinable()) thread_.join();
    daemon_.reset();
  }
  /// Again, with the same data.
  void restart() {
    stop();
    start("sim:", "127.0.0.1:0");
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] const std::string& key() const { return daemon_->key(); }
  [[nodiscard]] const std::filesystem::path& data() const { return folder_.path(); }

  [[nodiscard]] HttpReply get(std::string_view target) const {
    return request(port_, "GET", target);
  }
  [[nodiscard]] HttpReply put(std::string_view target, std::string_view body) const {
    return request(port_, "PUT", target, body);
  }
  [[nodiscard]] HttpReply post(std::string_view target, std::string_view body = "") const {
    return request(port_, "POST", target, body);
  }
  [[nodiscard]] HttpReply remove(std::string_view target) const {
    return request(port_, "DELETE", target);
  }

 private:
  void start(std::string printer, std::string listen) {
    goes_on_ = true;
    Daemon::Options options;
    options.data = folder_.path();
    options.listen = std::move(listen);
    options.port = std::move(printer);
    options.http = limits_;
    options.camera = camera_;
    auto daemon = Daemon::start(options);
    INFO((daemon ? "" : daemon.error().message));
    REQUIRE(daemon);
    daemon_ = std::move(*daemon);
    const std::string url = daemon_->url();
    port_ = static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1)));
    thread_ = std::thread([this] { daemon_->run([this] { return goes_on_.load(); }); });
  }

  const HttpLimits limits_;
  const std::string camera_;
  TemporaryFolder folder_;
  std::unique_ptr<Daemon> daemon_;
  std::atomic<bool> goes_on_{true};
  std::thread thread_;
  std::uint16_t port_ = 0;
};

/// Listens to the events of a daemon. Waits at most two minutes for anything: the heartbeat keeps
/// a stream open on which what is waited for never comes.
class EventReader {
 public:
  /// \param head further header lines, each ended by "\r\n".
  explicit EventReader(const RunningDaemon& daemon, const std::string& head = "")
      : client_(daemon.port()) {
    client_.send("GET /api/v1/events HTTP/1.1\r\nHost: localhost\r\n" + head + "\r\n");
    const std::string answer = client_.read_until("\r\n\r\n");
    REQUIRE(answer.find(" 200 ") != answer.npos);
  }

  /// The next event of `type` for which `wanted` holds; null if the stream ends before.
  template <typename Wanted>
  [[nodiscard]] nlohmann::json wait(const std::string& type, Wanted wanted) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (std::chrono::steady_clock::now() < end) {
      const std::string text = client_.read_until("\n\n");
      if (!text.ends_with("\n\n")) break;
      const std::string seen = text.substr(0, text.find("\ndata: "));
      const bool is_wanted = seen.ends_with("event: " + type);
      if (!is_wanted && !seen.ends_with("event: state")) continue;
      const auto json = nlohmann::json::parse(text.substr(text.find("data: ") + 6));
      if (json.contains("job")) at_work_ = !json["job"].is_null();
      if (is_wanted && wanted(json)) return json;
    }
    UNSCOPED_INFO("no such event: " << type);
    return {};
  }
  /// The state after the job that is under way, or else the next one, is over.
  [[nodiscard]] nlohmann::json wait_for_rest() {
    if (!at_work_) {
      static_cast<void>(wait("state", [](const auto& json) { return !json["job"].is_null(); }));
    }
    return wait("state", [](const auto& json) { return json["job"].is_null(); });
  }

 private:
  HttpClient client_;
  bool at_work_ = false;  ///< By the last event that was seen.
};

/// The loopback under an address that is none for the daemon: a key is needed, and nobody but this
/// machine can come.
inline constexpr const char* kNeedsKey = "[::ffff:127.0.0.1]:0";

inline std::string example(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(std::string(SLIPSTICK_SOURCE_DIR) + "/configs/solids/" + name).rdbuf();
  return text.str();
}

inline nlohmann::json json_of(const HttpReply& reply) {
  INFO(reply.status << " " << reply.body);
  return nlohmann::json::parse(reply.body);
}

}  // namespace slipstick::test
