#include "sim/control_socket.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace slipstick {

namespace {

UniqueFd new_socket() {
  return UniqueFd(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

/// Whether a socket lies at the address that nobody listens at any more.
bool is_left_over(const std::string& path, const sockaddr_un& address) {
  std::error_code error;
  if (!std::filesystem::is_socket(path, error)) return false;
  const UniqueFd probe = new_socket();
  const auto* generic = reinterpret_cast<const sockaddr*>(&address);
  return ::connect(probe.get(), generic, sizeof address) != 0 && errno == ECONNREFUSED;
}

}  // namespace

Result<ControlSocket> ControlSocket::open(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    return fail(ErrorCode::kInput, fmt::format("{}: longer than a socket's path can be ({} bytes)",
                                               path, sizeof address.sun_path - 1));
  }
  path.copy(static_cast<char*>(address.sun_path), path.size());
  if (is_left_over(path, address)) ::unlink(path.c_str());
  UniqueFd listener = new_socket();
  const auto* generic = reinterpret_cast<const sockaddr*>(&address);
  if (::bind(listener.get(), generic, sizeof address) != 0 || ::listen(listener.get(), 1) != 0) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("{}: cannot listen here: {}", path, std::strerror(errno)));
  }
  return ControlSocket(std::move(listener), path);
}

ControlSocket::~ControlSocket() {
  if (listener_.valid()) ::unlink(path_.c_str());
}

void ControlSocket::accept() {
  UniqueFd client(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!client.valid()) return;
  client_ = std::move(client);
  heard_.clear();
}

void ControlSocket::serve(const Obey& obey) {
  std::array<char, kLineMax> buffer{};
  const ssize_t count = ::read(client_.get(), buffer.data(), buffer.size());
  if (count == 0 || (count < 0 && errno != EAGAIN)) return client_.reset();
  if (count < 0) return;
  heard_.append(buffer.data(), static_cast<std::size_t>(count));
  std::string answers;
  for (std::size_t end = heard_.find('\n'); end != std::string::npos; end = heard_.find('\n')) {
    answers += obey(std::string_view(heard_).substr(0, end)) + "\n";
    heard_.erase(0, end + 1);
  }
  const ssize_t sent = ::send(client_.get(), answers.data(), answers.size(), MSG_NOSIGNAL);
  const bool all = sent == static_cast<ssize_t>(answers.size());
  if (!all || heard_.size() >= kLineMax) client_.reset();
}

}  // namespace slipstick
