// Streams of events and push sockets: what becomes of a connection whose request asks for one.
#include <fmt/format.h>

#include <boost/asio/write.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <sstream>

#include "host/serve/http_session.h"
#include "host/serve/push_session.h"

namespace slipstick {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;

constexpr std::chrono::seconds kHeartbeat{15};

std::string event_text(const EventLog::Event& event) {
  return fmt::format("id: {}\nevent: {}\ndata: {}\n\n", event.number, event.type, event.data);
}

}  // namespace

// New events, if this is a stream that is not writing yet.
void HttpSession::flush() {
  if (writing_) return;
  if (!still_admitted()) return end_stream();
  const EventLog::News news = server_.events->since(seen_);
  const auto now = std::chrono::steady_clock::now();
  std::string text = news.missed ? ": some events were missed\n\n" : "";
  for (const EventLog::Event& event : news.events) text += event_text(event);
  if (!news.events.empty()) seen_ = news.events.back().number;
  if (text.empty() && now - written_ > kHeartbeat) text = ": still here\n\n";
  if (!text.empty()) write_stream(std::move(text));
}

void HttpSession::begin_stream() {
  if (server_.listeners() >= server_.limits.streams) {
    return refuse(error_response(503, "too many listen to events already"));
  }
  seen_ = server_.events->last();
  HttpResponse response = server_.site.answer(*route_, request_);
  http::response_header<> head;
  head.version(11);
  head.result(response.status);
  head.set(http::field::content_type, response.type);
  head.set(http::field::connection, "close");
  add_common_headers(head);
  std::ostringstream text;
  text << head;
  server_.streams.insert(this);
  admitted_ = std::chrono::steady_clock::now();
  server_.seats.does(seat_, HttpSeats::Doing::kService);
  write_stream(text.str() + response.body);
  watch_for_end();
}

void HttpSession::write_stream(std::string text) {
  writing_ = true;
  outgoing_ = std::move(text);
  written_ = std::chrono::steady_clock::now();
  stream_.expires_after(server_.limits.write_patience);
  asio::async_write(stream_, asio::buffer(outgoing_),
                    [self = shared_from_this()](ErrorValue error, std::size_t) {
                      self->writing_ = false;
                      if (error) return self->end_stream();
                      self->flush();
                    });
}

// Nothing more is expected from the client; its end is.
void HttpSession::watch_for_end() {
  stream_.expires_never();
  stream_.async_read_some(asio::buffer(chunk_),
                          [self = shared_from_this()](ErrorValue error, std::size_t) {
                            if (error) return self->end_stream();
                            self->watch_for_end();
                          });
}

bool HttpSession::is_upgrade() const {
  return beast::websocket::is_upgrade(parser_->get());
}

// From now on this only keeps the seat.
void HttpSession::begin_push() {
  if (!parser_->is_done() || buffer_.size() != 0) {
    return refuse(error_response(400, "a request for a WebSocket is followed by its answer"));
  }
  if (auto fault = websocket_fault(request_)) return refuse(std::move(*fault));
  const bool granted = server_.hub->admits(request_);
  if (granted && server_.listeners() >= server_.limits.streams) {
    return refuse(error_response(503, "too many listen to events already"));
  }
  using Framing = PushClient::Framing;
  using Admission = PushClient::Admission;
  const PushClient client(request_.parameter("session").empty() ? Framing::kRaw : Framing::kSockJs,
                          granted ? Admission::kGranted : Admission::kByAuth);
  stream_.expires_never();
  const auto push =
      std::make_shared<PushSession>(server_, shared_from_this(), std::move(stream_), client);
  push_ = push;
  push->accept(parser_->get());
}

// Sessions end and keys are removed while somebody listens by them.
bool HttpSession::is_to_be_asked_again() {
  const auto now = std::chrono::steady_clock::now();
  if (now - admitted_ < server_.limits.admission_lasts) return false;
  admitted_ = now;
  return true;
}

bool HttpSession::still_admitted() {
  return !is_to_be_asked_again() || server_.site.still_admits(request_.caller);
}

bool HttpSession::still_admitted_to_push() {
  return !is_to_be_asked_again() || server_.hub->admits(request_);
}

void HttpSession::end_stream() {
  server_.streams.erase(this);
  stream_.close();
}

}  // namespace slipstick
