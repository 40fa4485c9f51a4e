#pragma once

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "host/serve/http_session.h"
#include "host/serve/push_client.h"

namespace slipstick {

/// The request for a WebSocket is none that can be granted: the refusal, or nothing.
[[nodiscard]] std::optional<HttpResponse> websocket_fault(const HttpRequest& head);

/// A listener's WebSocket: OctoPrint's push socket. It writes one frame at a time and keeps no
/// others; who does not take one, does not answer pings or says too much is cut off. Lives as long
/// as an operation of it is under way. Threads: that of `io`.
class PushSession : public std::enable_shared_from_this<PushSession> {
 public:
  static constexpr std::size_t kMessageMax = 16 << 10;  ///< Of the client.

  /// \param keeper whose connection this was: it keeps the seat.
  PushSession(HttpShared& server, std::shared_ptr<HttpSession> keeper,
              boost::beast::tcp_stream stream, const PushClient& client);
  ~PushSession();
  PushSession(const PushSession&) = delete;
  PushSession& operator=(const PushSession&) = delete;

  using Request = boost::beast::http::request<boost::beast::http::buffer_body>;
  /// Answers the request for it, and begins.
  void accept(const Request& request);
  /// Says what is new, if it is not saying something yet.
  void flush();
  /// Ends it at once.
  void cut_off();
  /// Whether it counts among those who listen to events.
  [[nodiscard]] bool listens() const { return listens_; }

 private:
  using ErrorValue = boost::system::error_code;
  using Time = PushClient::Time;

  void read();
  void on_read(ErrorValue error);
  void after(PushClient::Heard heard);
  [[nodiscard]] bool waited_too_long(Time now) const;
  void become_listener();
  void write(std::string frame);
  void say_goodbye(boost::beast::websocket::close_code code, const char* reason);
  void close();

  HttpShared& server_;
  const std::shared_ptr<HttpSession> keeper_;
  boost::beast::websocket::stream<boost::beast::tcp_stream, false> stream_;  // not compressed
  PushClient client_;
  const bool by_request_;  ///< Admitted by what its request showed, not by an `auth` message.
  boost::beast::flat_buffer incoming_{kMessageMax};
  std::string outgoing_;
  bool open_ = false;
  bool listens_ = false;
  bool writing_ = false;
  Time written_{};
  const Time began_;
  std::optional<boost::beast::websocket::close_reason> goodbye_;
};

}  // namespace slipstick
