// OctoPrint's push socket, by Beast.
#include "host/serve/push_session.h"

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>

namespace slipstick {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;

PushClient::Time now() {
  return std::chrono::steady_clock::now();
}

}  // namespace

std::optional<HttpResponse> websocket_fault(const HttpRequest& head) {
  constexpr std::size_t kKeySize = 24;  // 16 bytes in base 64
  if (head.header("sec-websocket-version") != "13") {
    HttpResponse response = error_response(426, "WebSockets are of version 13 here");
    response.headers.emplace_back("Sec-WebSocket-Version", "13");
    return response;
  }
  if (head.header("sec-websocket-key").size() == kKeySize) return {};
  return error_response(400, "Sec-WebSocket-Key: must be 16 bytes in base 64");
}

PushSession::PushSession(HttpShared& server, std::shared_ptr<HttpSession> keeper,
                         beast::tcp_stream stream, const PushClient& client)
    : server_(server),
      keeper_(std::move(keeper)),
      stream_(std::move(stream)),
      client_(client),
      by_request_(client.admitted()),
      began_(now()) {
  server_.pushes.insert(this);
}

PushSession::~PushSession() {
  server_.pushes.erase(this);
}

void PushSession::accept(const Request& request) {
  stream_.set_option(websocket::stream_base::timeout{server_.limits.write_patience,
                                                     server_.limits.push_patience, true});
  stream_.read_message_max(kMessageMax);
  stream_.text(true);
  stream_.control_callback([this](websocket::frame_type, beast::string_view) {
    if (client_.count(now()) == PushClient::Heard::kTooMuch) cut_off();
  });
  if (client_.admitted()) become_listener();
  stream_.async_accept(request, [self = shared_from_this()](ErrorValue error) {
    if (error) return;
    self->open_ = true;
    self->flush();
    self->read();
  });
}

void PushSession::read() {
  stream_.async_read(incoming_, [self = shared_from_this()](ErrorValue error, std::size_t) {
    self->on_read(error);
  });
}

void PushSession::on_read(ErrorValue error) {
  if (error || goodbye_) return;  // gone, or about to be
  const std::string frame = beast::buffers_to_string(incoming_.data());
  incoming_.consume(incoming_.size());
  after(client_.hear(frame, *server_.hub, now()));
  if (!goodbye_) flush();
  if (!goodbye_) read();
}

void PushSession::after(PushClient::Heard heard) {
  if (heard == PushClient::Heard::kTooMuch) {
    return say_goodbye(websocket::close_code::policy_error, "too many messages");
  }
  if (!client_.admitted() || listens_) return;
  if (server_.listeners() >= server_.limits.streams) {
    return say_goodbye(websocket::close_code::try_again_later, "too many listen already");
  }
  become_listener();
}

void PushSession::become_listener() {
  listens_ = true;
  keeper_->serve();
}

// Once a turn at least, so that no timer is needed.
void PushSession::flush() {
  const Time time = now();
  if (waited_too_long(time)) return cut_off();
  if (by_request_ && !keeper_->still_admitted_to_push()) return cut_off();
  if (!open_ || goodbye_ || writing_) return;
  if (!client_.admitted() && time - began_ > server_.limits.head_patience) {
    return say_goodbye(websocket::close_code::policy_error, "no auth message came");
  }
  if (auto frame = client_.next(*server_.hub, time)) write(std::move(*frame));
}

bool PushSession::waited_too_long(Time time) const {
  return writing_ && time - written_ > server_.limits.write_patience;
}

void PushSession::write(std::string frame) {
  writing_ = true;
  written_ = now();
  outgoing_ = std::move(frame);
  stream_.async_write(asio::buffer(outgoing_),
                      [self = shared_from_this()](ErrorValue error, std::size_t) {
                        self->writing_ = false;
                        if (error) return;
                        if (self->goodbye_) return self->close();
                        self->flush();
                      });
}

void PushSession::say_goodbye(websocket::close_code code, const char* reason) {
  goodbye_.emplace(code, reason);
  if (writing_) return;  // closed behind it
  auto farewell = client_.farewell();
  if (farewell) return write(std::move(*farewell));
  close();
}

void PushSession::close() {
  stream_.async_close(*goodbye_, [self = shared_from_this()](ErrorValue) {});
}

void PushSession::cut_off() {
  beast::get_lowest_layer(stream_).close();
}

}  // namespace slipstick
