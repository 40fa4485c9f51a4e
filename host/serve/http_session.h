#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_static_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "host/serve/http_seats.h"
#include "host/serve/http_server.h"
#include "host/serve/upload_body.h"

namespace slipstick {

class HttpSession;
class PushSession;

/// What the connections of one server share. Sessions know it to their end, which may be that of
/// `io`: it comes last.
struct HttpShared {
  HttpShared(HttpSite made, const HttpLimits& bounds)
      : site(std::move(made)),
        limits(bounds),
        seats(bounds.connections, bounds.connections_of_one) {}

  const HttpSite site;
  const HttpLimits limits;
  /// How many listen to events.
  [[nodiscard]] int listeners() const;

  const EventLog* events = nullptr;  ///< Set once, by `HttpServer::run`.
  std::optional<PushHub> hub;        ///< Likewise.
  HttpSeats seats;
  std::map<HttpSeats::Seat, HttpSession*> sessions;
  std::set<HttpSession*> streams;
  std::set<PushSession*> pushes;
  int slow_requests = 0;
  int secret_requests = 0;
  boost::asio::io_context io{1};
  boost::asio::thread_pool slow{1};
};

/// Puts in what every response carries.
void add_common_headers(boost::beast::http::fields& fields);

/// One connection: requests one after the other, or a stream of events. Lives as long as an
/// operation of it is under way. Threads: that of `io`.
class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(HttpShared& server, boost::asio::ip::tcp::socket socket, HttpSeats::Seat seat);
  ~HttpSession();
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  /// Waits for the next request.
  void read_head();
  /// Sends new events, if this is a stream that is not writing yet.
  void flush();
  /// Ends it at once.
  void cut_off();
  /// It does not give way to others any more.
  void serve() { server_.seats.does(seat_, HttpSeats::Doing::kService); }
  /// Whether who opened a push socket by this request may still listen.
  [[nodiscard]] bool still_admitted_to_push();

 private:
  using ErrorValue = boost::system::error_code;
  static constexpr std::size_t kChunk = 64 << 10;

  void on_head(ErrorValue error);
  void follow_route();
  void take_head();
  void begin_body();
  void read_body();
  void read_more();
  void on_body(ErrorValue error);
  void answer();
  void answer_slowly();
  [[nodiscard]] int& waiting_like_this();
  void refuse(HttpResponse response);
  void send(HttpResponse response);
  void sent();
  void linger(int reads);
  void close();
  void begin_stream();
  [[nodiscard]] bool is_upgrade() const;
  void begin_push();
  void write_stream(std::string text);
  void watch_for_end();
  void end_stream();
  [[nodiscard]] bool is_to_be_asked_again();
  [[nodiscard]] bool still_admitted();

  HttpShared& server_;
  const HttpSeats::Seat seat_;
  boost::beast::tcp_stream stream_;
  boost::beast::flat_static_buffer<HttpLimits::kHead + kChunk> buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::buffer_body>> parser_;
  std::array<char, kChunk> chunk_{};
  std::size_t taken_ = 0;  // of it
  HttpRequest request_;
  const Route* route_ = nullptr;
  std::optional<UploadBody> upload_;
  boost::beast::http::response<boost::beast::http::empty_body> continue_;
  boost::beast::http::response<boost::beast::http::string_body> response_;
  bool head_only_ = false;  // HEAD
  bool keep_ = false;
  bool linger_ = false;
  // A stream of events.
  std::int64_t seen_ = 0;
  bool writing_ = false;
  std::string outgoing_;
  std::chrono::steady_clock::time_point written_{};
  std::weak_ptr<PushSession> push_;  // what this connection became
  std::chrono::steady_clock::time_point admitted_{};
};

}  // namespace slipstick
