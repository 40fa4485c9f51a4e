// Requests and responses on a connection, by Beast.
#include "host/serve/http_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <utility>

#include "host/serve/file_names.h"
#include "host/serve/push_session.h"

namespace slipstick {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using tcp = asio::ip::tcp;

constexpr std::chrono::seconds kLingerPatience{5};
constexpr int kLingerReads = 64;

HttpMethod method_of(http::verb verb) {
  switch (verb) {
    case http::verb::get:
    case http::verb::head:
      return HttpMethod::kGet;
    case http::verb::post:
      return HttpMethod::kPost;
    case http::verb::put:
      return HttpMethod::kPut;
    case http::verb::delete_:
      return HttpMethod::kDelete;
    default:
      return HttpMethod::kOther;
  }
}

bool is_of_http(const boost::system::error_code& error) {
  return error.category() == http::make_error_code(http::error::bad_method).category();
}

std::string lower(beast::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

// What is to be stored need not be sent if it cannot be called that.
Result<FileName> name_in_address(const HttpRequest& request) {
  const std::string& path = request.parameter("path");
  return FileName::from(path.empty() ? std::string_view(request.parameter("name"))
                                     : last_segment(path));
}

}  // namespace

int HttpShared::listeners() const {
  return static_cast<int>(streams.size()) +
         static_cast<int>(std::ranges::count_if(pushes, &PushSession::listens));
}

// Nothing here is to be guessed at, framed or kept.
void add_common_headers(http::fields& fields) {
  fields.set("X-Content-Type-Options", "nosniff");
  fields.set("X-Frame-Options", "DENY");
  fields.set("Referrer-Policy", "no-referrer");
  fields.set(http::field::cache_control, "no-store");
}

HttpSession::HttpSession(HttpShared& server, tcp::socket socket, HttpSeats::Seat seat)
    : server_(server), seat_(seat), stream_(std::move(socket)) {
  server_.sessions.emplace(seat_, this);
}
HttpSession::~HttpSession() {
  server_.seats.leave(seat_);
  server_.sessions.erase(seat_);
  server_.streams.erase(this);
}

void HttpSession::cut_off() {
  if (const auto push = push_.lock()) return push->cut_off();
  stream_.close();
}

void HttpSession::read_head() {
  parser_.emplace();
  parser_->header_limit(HttpLimits::kHead);
  parser_->body_limit(HttpLimits::kUpload);
  request_ = {};
  head_only_ = false;
  upload_.reset();
  server_.seats.does(seat_, HttpSeats::Doing::kSpeech);
  stream_.expires_after(server_.limits.head_patience);
  http::async_read_header(
      stream_, buffer_, *parser_,
      [self = shared_from_this()](ErrorValue error, std::size_t) { self->on_head(error); });
}

void HttpSession::on_head(ErrorValue error) {
  if (error == http::error::end_of_stream) return close();
  if (error == http::error::header_limit) return refuse(error_response(431, "head too large"));
  if (error == http::error::body_limit) return refuse(error_response(413, "more than 1 GiB"));
  if (is_of_http(error)) return refuse(error_response(400, "not an HTTP/1.1 request"));
  if (error) return;  // gone, or too slow
  take_head();
  auto target = parse_http_target(std::string(parser_->get().target()));
  if (!target) return refuse(error_response(400, "not an address"));
  request_.target = std::move(*target);
  Found found = server_.site.admit(request_);
  if (found.route == nullptr && parser_->is_done()) {
    keep_ = parser_->get().keep_alive();
    return send(std::move(found.refusal));
  }
  if (found.route == nullptr) return refuse(std::move(found.refusal));
  route_ = found.route;
  request_.parameters = std::move(found.parameters);
  request_.caller = std::move(found.caller);
  follow_route();
}

void HttpSession::follow_route() {
  if (route_->kind == RouteKind::kEvents && !head_only_) return begin_stream();
  if (route_->kind == RouteKind::kPush && is_upgrade()) return begin_push();
  begin_body();
}

void HttpSession::take_head() {
  const auto& head = parser_->get();
  request_.method = method_of(head.method());
  head_only_ = head.method() == http::verb::head;
  ErrorValue error;
  request_.peer = http_peer(stream_.socket().remote_endpoint(error).address().to_string());
  for (const auto& field : head) {
    request_.headers.emplace(lower(field.name_string()), std::string(field.value()));
  }
}

void HttpSession::begin_body() {
  if (route_->body == RouteBody::kText &&
      parser_->content_length().value_or(0) > HttpLimits::kText) {
    return refuse(error_response(413, "more than 1 MiB"));
  }
  if (route_->body == RouteBody::kUpload) {
    const auto name = name_in_address(request_);
    if (!name) return refuse(error_response(name.error()));
  }
  if (route_->body != RouteBody::kText) {
    std::optional<std::string> boundary;
    if (route_->body == RouteBody::kForm) {
      boundary = MultipartParser::boundary_of(request_.header("content-type"));
      if (!boundary) return refuse(error_response(415, "the body must be multipart/form-data"));
    }
    auto upload = UploadBody::create(server_.site.upload_path(), boundary);
    if (!upload) return refuse(error_response(upload.error()));
    upload_.emplace(std::move(*upload));
  }
  if (!beast::iequals(request_.header("expect"), "100-continue")) return read_body();
  continue_ = http::response<http::empty_body>(http::status::continue_, 11);
  stream_.expires_after(server_.limits.write_patience);
  http::async_write(stream_, continue_, [self = shared_from_this()](ErrorValue error, std::size_t) {
    if (!error) self->read_body();
  });
}

void HttpSession::read_body() {
  if (parser_->is_done()) return answer();
  parser_->get().body().data = chunk_.data();
  parser_->get().body().size = chunk_.size();
  taken_ = 0;
  server_.seats.does(seat_, HttpSeats::Doing::kTransfer);
  stream_.expires_after(server_.limits.body_patience);
  read_more();
}

// What comes is looked at as it comes, but patience begins anew with whole chunks only.
void HttpSession::read_more() {
  http::async_read_some(
      stream_, buffer_, *parser_,
      [self = shared_from_this()](ErrorValue error, std::size_t) { self->on_body(error); });
}

void HttpSession::on_body(ErrorValue error) {
  if (error == http::error::body_limit) return refuse(error_response(413, "more than 1 GiB"));
  if (error && error != http::error::need_buffer) {
    if (is_of_http(error)) refuse(error_response(400, "the body is not what its head says"));
    return;  // gone, or too slow
  }
  const std::size_t had = std::exchange(taken_, chunk_.size() - parser_->get().body().size);
  const std::string_view bytes(chunk_.data() + had, taken_ - had);
  if (upload_) {
    if (const auto ok = upload_->write(bytes); !ok) {
      return refuse(upload_->name_is_wrong() ? error_response(415, ok.error().message)
                                             : error_response(ok.error()));
    }
  } else {
    if (request_.body.size() + bytes.size() > HttpLimits::kText) {
      return refuse(error_response(413, "more than 1 MiB"));
    }
    request_.body += bytes;
  }
  if (parser_->is_done() || taken_ == chunk_.size()) return read_body();
  read_more();
}

void HttpSession::answer() {
  if (upload_) {
    auto upload = upload_->finish();
    if (!upload) return refuse(error_response(upload.error()));
    request_.upload = std::move(*upload);
  }
  keep_ = parser_->get().keep_alive();
  const bool is_slow = route_->kind == RouteKind::kSlow || route_->kind == RouteKind::kSecret;
  if (!is_slow) return send(server_.site.answer(*route_, request_));
  answer_slowly();
}

// Counted apart: passwords of strangers do not keep out layers.
int& HttpSession::waiting_like_this() {
  return route_->kind == RouteKind::kSecret ? server_.secret_requests : server_.slow_requests;
}

void HttpSession::answer_slowly() {
  const bool is_secret = route_->kind == RouteKind::kSecret;
  if (waiting_like_this() ==
      (is_secret ? server_.limits.secret_requests : server_.limits.slow_requests)) {
    return send(error_response(503, is_secret
                                        ? "too many log in at once; try again in a few seconds"
                                        : "too many layers are asked for; ask again later"));
  }
  ++waiting_like_this();
  server_.seats.does(seat_, HttpSeats::Doing::kService);
  stream_.expires_never();
  asio::post(server_.slow, [self = shared_from_this()] {
    auto response = self->server_.site.answer(*self->route_, self->request_);
    // The session is let go on the server's thread, whatever happens.
    asio::post(self->server_.io, [self, response = std::move(response)]() mutable {
      --self->waiting_like_this();
      self->send(std::move(response));
    });
  });
}

// An answer before the request was read: the connection cannot be used for another.
void HttpSession::refuse(HttpResponse response) {
  upload_.reset();
  keep_ = false;
  linger_ = true;
  send(std::move(response));
}

void HttpSession::send(HttpResponse response) {
  response_ = {};
  response_.result(response.status);
  response_.version(11);
  add_common_headers(response_);
  if (!response.type.empty()) response_.set(http::field::content_type, response.type);
  for (const auto& [name, value] : response.headers) response_.set(name, value);
  response_.keep_alive(keep_);
  response_.body() = std::move(response.body);
  response_.prepare_payload();
  if (head_only_) response_.body().clear();  // its length is told all the same
  server_.seats.does(seat_, HttpSeats::Doing::kTransfer);
  stream_.expires_after(server_.limits.write_patience);
  http::async_write(stream_, response_, [self = shared_from_this()](ErrorValue error, std::size_t) {
    if (!error) self->sent();
  });
}

void HttpSession::sent() {
  if (keep_) return read_head();
  close();
  if (!linger_) return;
  server_.seats.does(seat_, HttpSeats::Doing::kSpeech);
  stream_.expires_after(kLingerPatience);
  linger(kLingerReads);
}

// Reads what the client still sends, so that it gets to read why it was refused.
void HttpSession::linger(int reads) {
  if (reads == 0) return;
  stream_.async_read_some(asio::buffer(chunk_),
                          [self = shared_from_this(), reads](ErrorValue error, std::size_t) {
                            if (!error) self->linger(reads - 1);
                          });
}

void HttpSession::close() {
  ErrorValue ignored;
  stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
}

}  // namespace slipstick
