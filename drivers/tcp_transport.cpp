#include "drivers/tcp_transport.h"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "drivers/fd_transport.h"

namespace slipstick {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

/// 0 or the errno of what went wrong, ETIMEDOUT when nobody answered.
int finish_connecting(int fd, std::chrono::microseconds patience) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(patience);
  pollfd polled{fd, POLLOUT, 0};
  const int ready = ::poll(&polled, 1, static_cast<int>(left.count()));
  if (ready == 0) return ETIMEDOUT;
  if (ready < 0) return errno;
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

int connect_to(int fd, const addrinfo& address, std::chrono::microseconds patience) {
  if (fd < 0) return errno;
  if (::connect(fd, address.ai_addr, address.ai_addrlen) == 0) return 0;
  return errno == EINPROGRESS ? finish_connecting(fd, patience) : errno;
}

Result<std::unique_ptr<Transport>> adopt_socket(UniqueFd fd, const std::string& name) {
  const int on = 1;
  // Lines are short and each waits for its answer: Nagle would add 40 ms to some of them.
  ::setsockopt(fd.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  auto transport = FdTransport::adopt(std::move(fd), name);
  if (!transport) return fail(transport.error());
  return std::unique_ptr<Transport>(std::move(*transport));
}

}  // namespace

Result<std::unique_ptr<Transport>> open_tcp(const std::string& host, std::uint16_t port,
                                            std::chrono::microseconds patience) {
  const std::string name = fmt::format("tcp:{}:{}", host, port);
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int trouble = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found);
  if (trouble != 0) {
    return fail(ErrorCode::kInput,
                fmt::format("{}: cannot resolve the host: {}", name, ::gai_strerror(trouble)));
  }
  const Addresses addresses(found, &::freeaddrinfo);
  int error = EHOSTUNREACH;
  for (const addrinfo* address = addresses.get(); address != nullptr; address = address->ai_next) {
    UniqueFd fd(::socket(address->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    error = connect_to(fd.get(), *address, patience);
    if (error == 0) return adopt_socket(std::move(fd), name);
  }
  return fail(error == ETIMEDOUT ? ErrorCode::kTimedOut : ErrorCode::kUnavailable,
              fmt::format("{}: cannot connect: {}; is the printer on and the port right?", name,
                          std::strerror(error)));
}

}  // namespace slipstick
