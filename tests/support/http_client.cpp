#include "tests/support/http_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <algorithm>
#include <cerrno>

#include "core/base/check.h"

namespace slipstick::test {
namespace {

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

void read_head(std::string_view head, HttpReply& reply) {
  reply.status = std::stoi(std::string(head.substr(9, 3)));
  while (true) {
    const std::size_t line = head.find("\r\n");
    if (line == head.npos) return;
    head.remove_prefix(line + 2);
    const std::size_t colon = head.find(": ");
    if (colon == head.npos) return;
    const std::size_t end = std::min(head.find("\r\n"), head.size());
    reply.headers[lower(std::string(head.substr(0, colon)))] =
        std::string(head.substr(colon + 2, end - colon - 2));
  }
}

}  // namespace

HttpClient::HttpClient(std::uint16_t port)
    : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  const timeval patience{60, 0};
  ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  // A server that is gone is an answer, too: every reply then has status 0.
  if (::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    socket_.reset();
  }
}

void HttpClient::send(std::string_view bytes) {
  while (socket_.valid() && !bytes.empty()) {
    const ssize_t sent = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return;  // refused before all was read: the reply says why
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

HttpReply HttpClient::reply() {
  HttpReply reply;
  const std::string head = read_until("\r\n\r\n");
  if (!head.ends_with("\r\n\r\n")) return reply;
  read_head(head, reply);
  if (reply.status == 100) return reply;
  const auto length = reply.headers.find("content-length");
  if (length == reply.headers.end()) {
    if (reply.status == 204) return reply;
    while (fill()) {
    }
    reply.body = std::exchange(pending_, {});
    return reply;
  }
  const std::size_t size = std::stoul(length->second);
  while (pending_.size() < size && fill()) {
  }
  reply.body = pending_.substr(0, size);
  pending_.erase(0, size);
  return reply;
}

std::string HttpClient::read_until(std::string_view end) {
  while (pending_.find(end) == pending_.npos && fill()) {
  }
  const std::size_t at = pending_.find(end);
  const std::size_t size = at == pending_.npos ? pending_.size() : at + end.size();
  std::string text = pending_.substr(0, size);
  pending_.erase(0, size);
  return text;
}

std::string HttpClient::read(std::size_t size) {
  while (pending_.size() < size && fill()) {
  }
  std::string bytes = pending_.substr(0, size);
  pending_.erase(0, size);
  return bytes;
}

bool HttpClient::ended() {
  while (fill()) {
  }
  return pending_.empty();
}

bool HttpClient::ended_within(std::chrono::milliseconds patience) {
  pollfd look{socket_.get(), POLLIN, 0};
  return ::poll(&look, 1, static_cast<int>(patience.count())) > 0 && !fill();
}

void HttpClient::end_sending() {
  ::shutdown(socket_.get(), SHUT_WR);
}

bool HttpClient::fill() {
  char bytes[16 << 10];
  if (!socket_.valid()) return false;
  ssize_t got = 0;
  do {
    got = ::recv(socket_.get(), bytes, sizeof bytes, 0);
  } while (got < 0 && errno == EINTR);  // a fuzzer has a timer
  if (got <= 0) return false;
  pending_.append(bytes, static_cast<std::size_t>(got));
  return true;
}

HttpReply request(std::uint16_t port, std::string_view method, std::string_view target,
                  std::string_view body, std::string_view head) {
  HttpClient client(port);
  std::string text;
  text.append(method).append(" ").append(target).append(" HTTP/1.1\r\nHost: localhost\r\n");
  text.append(head);
  if (!body.empty() || method != "GET") {
    text.append("Content-Length: ").append(std::to_string(body.size())).append("\r\n");
  }
  text.append("\r\n").append(body);
  client.send(text);
  return client.reply();
}

}  // namespace slipstick::test
