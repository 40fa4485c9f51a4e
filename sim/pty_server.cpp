#include "sim/pty_server.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <termios.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <system_error>

#include "sim/control.h"

namespace slipstick {

namespace {

/// Longest sleep: time is told to the printer at least so often.
constexpr Moment kTick{50'000};
constexpr double kSlowest = 0.01;
constexpr double kFastest = 1000;
constexpr std::size_t kChunk = 4096;
/// A host that sends faster than the board reads waits in its own buffers beyond this.
constexpr std::size_t kUnreadMax = 4096;

Moment times(Moment time, double factor) {
  return Moment(std::llround(static_cast<double>(time.count()) * factor));
}

tl::unexpected<Error> system_error(std::string_view what) {
  return fail(ErrorCode::kUnavailable, fmt::format("{}: {}", what, std::strerror(errno)));
}

std::string link_target(const std::string& path) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::read_symlink(path, error);
  return error ? std::string() : target.string();
}

/// Makes `path` lead to `device`; a link to a terminal left by an earlier run is replaced.
Result<void> make_link(const std::string& device, const std::string& path) {
  std::error_code error;
  if (link_target(path).starts_with("/dev/pts/")) std::filesystem::remove(path, error);
  std::filesystem::create_symlink(device, path, error);
  if (!error) return {};
  return fail(ErrorCode::kUnavailable,
              fmt::format("{}: cannot make a link to {} here: {}", path, device, error.message()));
}

void make_raw(int fd) {
  termios settings{};
  if (tcgetattr(fd, &settings) != 0) return;
  cfmakeraw(&settings);
  tcsetattr(fd, TCSANOW, &settings);
}

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

}  // namespace

Result<PtyServer> PtyServer::open(const PtyServerOptions& options, Printer printer) {
  if (options.pty_path.empty() && !options.tcp_port) {
    return fail(ErrorCode::kInput, "simulated printer: give a path for a terminal or a TCP port");
  }
  if (!(options.speed >= kSlowest && options.speed <= kFastest)) {
    return fail(ErrorCode::kInput, fmt::format("simulated printer: speed {}: give {} to {}",
                                               options.speed, kSlowest, kFastest));
  }
  PtyServer server(std::move(printer), options.speed);
  if (!options.pty_path.empty()) {
    if (auto opened = server.open_terminal(options.pty_path); !opened) return fail(opened.error());
  }
  if (options.tcp_port) {
    if (auto opened = server.listen_on(*options.tcp_port); !opened) return fail(opened.error());
  }
  if (!options.control_path.empty()) {
    auto control = ControlSocket::open(options.control_path);
    if (!control) return fail(control.error());
    server.control_.emplace(std::move(*control));
  }
  return server;
}

PtyServer::~PtyServer() {
  close_terminal();
}

void PtyServer::close_terminal() {
  std::error_code error;
  if (!link_.empty() && link_target(link_) == device_) std::filesystem::remove(link_, error);
  terminal_.reset();
  terminal_held_.reset();
}

Result<void> PtyServer::follow_cable() {
  if (printer_.plugged() == cable_in_) return {};
  cable_in_ = printer_.plugged();
  if (cable_in_) return link_.empty() ? Result<void>() : open_terminal(link_);
  close_terminal();
  client_.reset();
  return {};
}

Result<void> PtyServer::open_terminal(const std::string& path) {
  terminal_ = UniqueFd(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!terminal_.valid() || grantpt(terminal_.get()) != 0 || unlockpt(terminal_.get()) != 0) {
    return system_error("no pseudo-terminal");
  }
  std::array<char, 128> name{};
  if (ptsname_r(terminal_.get(), name.data(), name.size()) != 0) {
    return system_error("no name of the pseudo-terminal");
  }
  device_ = name.data();
  terminal_held_ = UniqueFd(::open(device_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  if (!terminal_held_.valid()) return system_error(device_);
  make_raw(terminal_held_.get());
  if (auto linked = make_link(device_, path); !linked) return linked;
  link_ = path;
  return {};
}

Result<void> PtyServer::listen_on(int port) {
  listener_ = UniqueFd(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!listener_.valid()) return system_error("no socket");
  const int on = 1;
  setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address = loopback(port);
  socklen_t size = sizeof address;
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  if (::bind(listener_.get(), generic, size) != 0 || ::listen(listener_.get(), 1) != 0 ||
      ::getsockname(listener_.get(), generic, &size) != 0) {
    return system_error(fmt::format("cannot listen on 127.0.0.1:{}", port));
  }
  tcp_port_ = ntohs(address.sin_port);
  return {};
}

void PtyServer::accept_client() {
  UniqueFd client(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!client.valid()) return;
  const int on = 1;
  setsockopt(client.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  client_ = std::move(client);
  printer_.reset();
}

void PtyServer::hear(int fd, Moment elapsed) {
  std::array<char, kChunk> buffer{};
  const ssize_t count = ::read(fd, buffer.data(), buffer.size());
  if (count > 0) {
    printer_.receive({buffer.data(), static_cast<std::size_t>(count)}, elapsed);
  } else if (fd == client_.get() && (count == 0 || errno != EAGAIN)) {
    client_.reset();
  }
}

/// Writes never wait: what nobody takes is lost, as on a serial line.
void PtyServer::speak() {
  std::array<char, kChunk> buffer{};
  while (const std::size_t count = printer_.take(buffer)) {
    if (terminal_.valid()) {
      [[maybe_unused]] const ssize_t taken = ::write(terminal_.get(), buffer.data(), count);
    }
    if (client_.valid()) {
      [[maybe_unused]] const ssize_t taken =
          ::send(client_.get(), buffer.data(), count, MSG_NOSIGNAL);
    }
  }
}

Result<void> PtyServer::wait(int stop_fd, Moment elapsed) {
  const short input = printer_.unread() < kUnreadMax ? POLLIN : 0;
  std::array<pollfd, 6> fds{{{stop_fd, POLLIN, 0},
                             {terminal_.get(), input, 0},
                             {cable_in_ ? listener_.get() : -1, POLLIN, 0},
                             {client_.get(), input, 0},
                             {control_ ? control_->listener() : -1, POLLIN, 0},
                             {control_ ? control_->client() : -1, POLLIN, 0}}};
  Moment next = elapsed + times(kTick, speed_);
  if (const auto m = printer_.next_event()) next = std::min(next, *m);
  if (const auto m = printer_.output_at()) next = std::min(next, *m);
  const std::chrono::nanoseconds patience = times(std::max(Moment(0), next - elapsed), 1 / speed_);
  const timespec timeout{0, static_cast<long>(patience.count())};
  if (::ppoll(fds.data(), fds.size(), &timeout, nullptr) < 0 && errno != EINTR) {
    return system_error("simulated printer: poll");
  }
  if ((fds[1].revents & POLLIN) != 0) hear(terminal_.get(), elapsed);
  if (fds[3].revents != 0) hear(client_.get(), elapsed);
  if ((fds[2].revents & POLLIN) != 0) accept_client();
  if (fds[5].revents != 0) {
    control_->serve([this](std::string_view line) { return obey_control(printer_, line); });
  }
  if ((fds[4].revents & POLLIN) != 0) control_->accept();
  return {};
}

Result<void> PtyServer::run(const std::stop_token& stop) {
  const UniqueFd stop_event(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!stop_event.valid()) return system_error("simulated printer: eventfd");
  const std::stop_callback wake(stop, [fd = stop_event.get()] { eventfd_write(fd, 1); });

  const auto started = std::chrono::steady_clock::now();
  const Moment began = printer_.now();
  while (!stop.stop_requested()) {
    const auto passed =
        std::chrono::duration_cast<Moment>(std::chrono::steady_clock::now() - started);
    const Moment elapsed = began + times(passed, speed_);
    printer_.advance(elapsed);
    if (auto followed = follow_cable(); !followed) return followed;
    speak();
    if (auto waited = wait(stop_event.get(), elapsed); !waited) return waited;
  }
  return {};
}

}  // namespace slipstick
