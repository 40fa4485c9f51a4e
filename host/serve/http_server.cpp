#include "host/serve/http_server.h"

#include <fmt/format.h>

#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <charconv>

#include "host/serve/http_session.h"
#include "host/serve/push_session.h"

namespace slipstick {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using tcp = asio::ip::tcp;

}  // namespace

class HttpServer::Implementation {
 public:
  Implementation(HttpSite site, const HttpLimits& limits) : shared_(std::move(site), limits) {}
  ~Implementation() {
    shared_.slow.stop();
    shared_.slow.join();
  }

  Result<void> listen(const std::string& address);
  void run(const EventLog& events, const std::function<bool()>& goes_on);
  void wake();
  [[nodiscard]] tcp::endpoint endpoint() const { return endpoint_; }

 private:
  void accept();
  void admit(tcp::socket socket);
  void tick(const std::function<bool()>& goes_on);
  void flush();

  HttpShared shared_;
  tcp::acceptor acceptor_{shared_.io};
  asio::steady_timer timer_{shared_.io};
  tcp::endpoint endpoint_;
  std::atomic<bool> woken_{false};
};

Result<void> HttpServer::Implementation::listen(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  std::string host = address.substr(0, colon);
  if (host.size() > 2 && host.front() == '[') host = host.substr(1, host.size() - 2);
  std::uint16_t port = 0;
  const char* end = address.data() + address.size();
  error_code error;
  const auto ip = asio::ip::make_address(host, error);
  if (colon == std::string::npos || error ||
      std::from_chars(address.data() + colon + 1, end, port).ptr != end) {
    return fail(ErrorCode::kInput,
                fmt::format("{} is not an address; try 127.0.0.1:5000 or 0.0.0.0:5000", address));
  }
  endpoint_ = {ip, port};
  acceptor_.open(endpoint_.protocol(), error);
  if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint_, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (!error) endpoint_ = acceptor_.local_endpoint(error);
  if (!error) return {};
  return fail(ErrorCode::kUnavailable,
              fmt::format("cannot listen on {}: {}", address, error.message()));
}

void HttpServer::Implementation::run(const EventLog& events, const std::function<bool()>& goes_on) {
  shared_.events = &events;
  shared_.hub.emplace(shared_.site.push, events);
  accept();
  tick(goes_on);
  shared_.io.run();
}

void HttpServer::Implementation::accept() {
  acceptor_.async_accept([this](error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) admit(std::move(socket));
    accept();
  });
}

// A client for whom nobody gives way is not answered.
void HttpServer::Implementation::admit(tcp::socket socket) {
  error_code error;
  const tcp::endpoint peer = socket.remote_endpoint(error);
  if (error) return;
  const auto place = shared_.seats.take(http_peer(peer.address().to_string()));
  if (!place) return;
  const auto gone = place->freed ? shared_.sessions.find(*place->freed) : shared_.sessions.end();
  if (gone != shared_.sessions.end()) gone->second->cut_off();
  std::make_shared<HttpSession>(shared_, std::move(socket), place->seat)->read_head();
}

void HttpServer::Implementation::tick(const std::function<bool()>& goes_on) {
  if (!goes_on()) return shared_.io.stop();
  flush();
  timer_.expires_after(kTick);
  timer_.async_wait([this, &goes_on](error_code) { tick(goes_on); });
}

void HttpServer::Implementation::flush() {
  shared_.hub->follow();
  // A stream that ends while it is flushed leaves the set.
  const std::set<HttpSession*> streams = shared_.streams;
  for (HttpSession* stream : streams) stream->shared_from_this()->flush();
  const std::set<PushSession*> pushes = shared_.pushes;
  for (PushSession* push : pushes) push->shared_from_this()->flush();
}

void HttpServer::Implementation::wake() {
  if (woken_.exchange(true)) return;
  asio::post(shared_.io, [this] {
    woken_ = false;
    flush();
  });
}

HttpServer::HttpServer(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

HttpServer::~HttpServer() = default;

Result<std::unique_ptr<HttpServer>> HttpServer::listen(const std::string& address, HttpSite site,
                                                       const HttpLimits& limits) {
  auto implementation = std::make_unique<Implementation>(std::move(site), limits);
  if (const auto ok = implementation->listen(address); !ok) return fail(ok.error());
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(implementation)));
}

std::string HttpServer::address() const {
  const tcp::endpoint at = implementation_->endpoint();
  const std::string host = at.address().to_string();
  return at.address().is_v6() ? fmt::format("[{}]:{}", host, at.port())
                              : fmt::format("{}:{}", host, at.port());
}

bool HttpServer::is_loopback() const {
  return implementation_->endpoint().address().is_loopback();
}

void HttpServer::run(const EventLog& events, const std::function<bool()>& goes_on) {
  implementation_->run(events, goes_on);
}

void HttpServer::wake() {
  implementation_->wake();
}

}  // namespace slipstick
