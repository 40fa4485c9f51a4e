#include "tests/support/web_listener.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include "core/base/check.h"

namespace slipstick::test {
namespace {

constexpr int kPatienceMs = 60'000;

bool is_whole(const std::string& text) {
  const std::size_t end = text.find("\r\n\r\n");
  const std::size_t length = text.find("Content-Length: ");
  if (end == text.npos || length == text.npos) return false;
  return text.size() == end + 4 + std::stoul(text.substr(length + 16));
}

}  // namespace

WebListener::WebListener() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const raw = reinterpret_cast<sockaddr*>(&address);
  SLIPSTICK_CHECK(::bind(socket_.get(), raw, size) == 0 && ::listen(socket_.get(), 8) == 0);
  SLIPSTICK_CHECK(::getsockname(socket_.get(), raw, &size) == 0);
  port_ = ntohs(address.sin_port);
}

std::string WebListener::url() const {
  return "http://127.0.0.1:" + std::to_string(port_) + "/hook";
}

std::string WebListener::request(const std::string& reply) {
  pollfd look{socket_.get(), POLLIN, 0};
  if (::poll(&look, 1, kPatienceMs) <= 0) return {};
  const UniqueFd peer(::accept4(socket_.get(), nullptr, nullptr, SOCK_CLOEXEC));
  std::string text;
  char bytes[4096];
  look.fd = peer.get();
  while (!is_whole(text) && ::poll(&look, 1, kPatienceMs) > 0) {
    const ssize_t got = ::recv(peer.get(), bytes, sizeof bytes, 0);
    if (got <= 0) break;
    text.append(bytes, static_cast<std::size_t>(got));
  }
  const std::string answer = "HTTP/1.1 " + reply + "\r\nConnection: close\r\n\r\n";
  ::send(peer.get(), answer.data(), answer.size(), MSG_NOSIGNAL);
  return text;
}

}  // namespace slipstick::test
