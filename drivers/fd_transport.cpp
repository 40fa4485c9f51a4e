#include "drivers/fd_transport.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "core/base/check.h"
#include "drivers/clock.h"

namespace slipstick {
namespace {

timespec to_timespec(std::chrono::microseconds time) {
  const auto left = std::max(time, std::chrono::microseconds::zero());
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
  return {static_cast<time_t>(seconds.count()),
          static_cast<long>(std::chrono::nanoseconds(left - seconds).count())};
}

bool may_try_again(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

/// A peer that closed must give EPIPE, not a signal: sockets need to be asked for that.
ssize_t write_quietly(int fd, std::string_view bytes) {
  const ssize_t sent = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  return sent < 0 && errno == ENOTSOCK ? ::write(fd, bytes.data(), bytes.size()) : sent;
}

}  // namespace

Result<std::unique_ptr<FdTransport>> FdTransport::adopt(UniqueFd fd, std::string name) {
  SLIPSTICK_CHECK(fd.get() >= 0);
  const int flags = ::fcntl(fd.get(), F_GETFL);
  UniqueFd bell(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (flags < 0 || ::fcntl(fd.get(), F_SETFL, flags | O_NONBLOCK) < 0 || bell.get() < 0) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("{}: cannot set it up: {}", name, std::strerror(errno)));
  }
  return std::unique_ptr<FdTransport>(
      new FdTransport(std::move(fd), std::move(bell), std::move(name)));
}

FdTransport::FdTransport(UniqueFd fd, UniqueFd bell, std::string name)
    : fd_(std::move(fd)), bell_(std::move(bell)), name_(std::move(name)) {}

Error FdTransport::gone(int error) const {
  const char* reason = error == 0 ? "the other side closed it" : std::strerror(error);
  return {ErrorCode::kUnavailable,
          fmt::format("{}: {}; check the cable and the power, then connect again", name_, reason)};
}

Result<void> FdTransport::await(short events, std::chrono::microseconds until) const {
  const SteadyClock clock;
  while (true) {
    std::array<pollfd, 2> polled{{{bell_.get(), POLLIN, 0}, {fd_.get(), events, 0}}};
    const timespec left = to_timespec(until - clock.now());
    const int ready = ::ppoll(polled.data(), polled.size(), &left, nullptr);
    if (ready < 0 && errno != EINTR) return fail(gone(errno));
    if (polled[0].revents != 0 && ready > 0) {
      return fail(ErrorCode::kCancelled, fmt::format("{}: shut down", name_));
    }
    // An error or a hang-up is told by the read or the write that follows.
    if (ready > 0) return {};
    if (clock.now() >= until) {
      return fail(ErrorCode::kTimedOut, fmt::format("{}: nothing happened in time", name_));
    }
  }
}

Result<std::size_t> FdTransport::read_some(std::span<char> buffer,
                                           std::chrono::microseconds patience) {
  SLIPSTICK_CHECK(!buffer.empty());
  const auto until = SteadyClock().now() + patience;
  while (true) {
    if (auto ready = await(POLLIN, until); !ready) return fail(ready.error());
    const ssize_t count = ::read(fd_.get(), buffer.data(), buffer.size());
    if (count > 0) return static_cast<std::size_t>(count);
    if (count == 0) return fail(gone(0));
    if (!may_try_again(errno)) return fail(gone(errno));
  }
}

Result<std::size_t> FdTransport::write_some(std::string_view bytes,
                                            std::chrono::microseconds patience) {
  SLIPSTICK_CHECK(!bytes.empty());
  const auto until = SteadyClock().now() + patience;
  while (true) {
    if (auto ready = await(POLLOUT, until); !ready) return fail(ready.error());
    const ssize_t count = write_quietly(fd_.get(), bytes);
    if (count > 0) return static_cast<std::size_t>(count);
    if (count < 0 && !may_try_again(errno)) return fail(gone(errno));
  }
}

Result<void> FdTransport::write_all(std::string_view bytes, std::chrono::microseconds patience) {
  const auto until = SteadyClock().now() + patience;
  while (!bytes.empty()) {
    const auto count = write_some(bytes, until - SteadyClock().now());
    if (!count) return fail(count.error());
    bytes.remove_prefix(*count);
  }
  return {};
}

void FdTransport::discard_output() noexcept {
  // Only terminals have a queue that can be emptied; others say ENOTTY.
  [[maybe_unused]] const int done = ::tcflush(fd_.get(), TCOFLUSH);
}

bool FdTransport::set_dtr(bool on) noexcept {
  const int line = TIOCM_DTR;
  return ::ioctl(fd_.get(), on ? TIOCMBIS : TIOCMBIC, &line) == 0;
}

void FdTransport::shut_down() noexcept {
  const std::uint64_t ring = 1;
  // The counter cannot overflow in practice, and then the bell is ringing anyway.
  [[maybe_unused]] const ssize_t written = ::write(bell_.get(), &ring, sizeof ring);
}

}  // namespace slipstick
