#include "drivers/pty_transport.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <termios.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "drivers/fd_transport.h"

namespace slipstick {
namespace {

bool make_raw(int fd) {
  termios settings{};
  if (::tcgetattr(fd, &settings) != 0) return false;
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(HUPCL);
  return ::tcsetattr(fd, TCSANOW, &settings) == 0;
}

}  // namespace

Result<std::unique_ptr<Transport>> open_pty(const std::string& path) {
  UniqueFd fd(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (fd.get() < 0 || !make_raw(fd.get())) {
    return fail(ErrorCode::kUnavailable, fmt::format("pty:{}: cannot open it as a terminal: {}",
                                                     path, std::strerror(errno)));
  }
  auto transport = FdTransport::adopt(std::move(fd), "pty:" + path);
  if (!transport) return fail(transport.error());
  return std::unique_ptr<Transport>(std::move(*transport));
}

}  // namespace slipstick
