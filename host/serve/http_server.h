#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "host/serve/event_log.h"
#include "host/serve/push_hub.h"
#include "host/serve/routes.h"

namespace slipstick {

/// What the server asks about each request.
struct HttpSite {
  /// Once the head is there, before any of the body is read: where it leads, or the refusal.
  std::function<Found(const HttpRequest& head)> admit;
  /// The answer. For slow routes on a thread of their own, otherwise on the server's.
  std::function<HttpResponse(const Route& route, const HttpRequest& request)> answer;
  /// Where the next upload may be written.
  std::function<std::filesystem::path()> upload_path;
  /// What OctoPrint's push socket tells, and whom. On the server's thread.
  PushSite push = {};
  /// Whether somebody who listens to events may go on.
  std::function<bool(const Caller& caller)> still_admits;
};

/// Bounds of what a connection may ask for, of the time each part may take, and of how many there
/// are.
struct HttpLimits {
  static constexpr std::uint32_t kHead = 16 << 10;
  static constexpr std::size_t kText = 1 << 20;
  static constexpr std::uint64_t kUpload = std::uint64_t{1} << 30;

  std::chrono::milliseconds head_patience{15'000};  ///< Also between requests.
  std::chrono::milliseconds body_patience{30'000};  ///< For each 64 KiB of it.
  std::chrono::milliseconds write_patience{30'000};
  /// A WebSocket whose client is silent for half of it is pinged, and ends with it. Until its
  /// client may listen it has as long as a head.
  std::chrono::milliseconds push_patience{60'000};
  int connections = 128;
  int connections_of_one = 32;  ///< Of one other machine; this one may have all.
  int streams = 64;             ///< Of events; they are among the connections.
  int slow_requests = 16;       ///< Under way, and waiting for the thread of slow routes.
  int secret_requests = 4;      ///< The same of those that may have a password hashed.
  std::chrono::milliseconds admission_lasts{5'000};  ///< Of who listens to events.
};

/// Speaks HTTP/1.1 on one address, on the thread that calls `run` and one more for slow routes.
/// Who keeps it waiting is cut off after a while, and at once where others want the connection.
class HttpServer {
 public:
  static constexpr std::chrono::milliseconds kTick{100};

  /// \param address "127.0.0.1:5000", "[::1]:5000"; port 0 takes any.
  /// \return kInput for an address that is none, kUnavailable if it cannot be had.
  [[nodiscard]] static Result<std::unique_ptr<HttpServer>> listen(const std::string& address,
                                                                  HttpSite site,
                                                                  const HttpLimits& limits = {});
  ~HttpServer();

  /// "127.0.0.1:43211".
  [[nodiscard]] std::string address() const;
  [[nodiscard]] bool is_loopback() const;

  /// Answers until `goes_on`, asked ten times a second, says no. Once. `events` are what event
  /// streams and push sockets tell.
  void run(const EventLog& events, const std::function<bool()>& goes_on);

  /// There are new events. Any thread, also before `run`.
  void wake();

 private:
  class Implementation;
  explicit HttpServer(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace slipstick
