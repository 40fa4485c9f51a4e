#include "drivers/serial_transport.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <libserialport.h>
#include <termios.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "drivers/fd_transport.h"

namespace slipstick {
namespace {

struct CloseAndFree {
  void operator()(sp_port* port) const {
    ::sp_close(port);
    ::sp_free_port(port);
  }
};
using PortHandle = std::unique_ptr<sp_port, CloseAndFree>;

/// libserialport opens and configures; the bytes go through the descriptor, because its blocking
/// calls cannot be interrupted by `shut_down`.
class SerialTransport final : public Transport {
 public:
  SerialTransport(PortHandle port, std::unique_ptr<FdTransport> bytes)
      : port_(std::move(port)), bytes_(std::move(bytes)) {}

  [[nodiscard]] Result<std::size_t> read_some(std::span<char> buffer,
                                              std::chrono::microseconds patience) override {
    return bytes_->read_some(buffer, patience);
  }
  [[nodiscard]] Result<std::size_t> write_some(std::string_view bytes,
                                               std::chrono::microseconds patience) override {
    return bytes_->write_some(bytes, patience);
  }
  [[nodiscard]] Result<void> write_all(std::string_view bytes,
                                       std::chrono::microseconds patience) override {
    return bytes_->write_all(bytes, patience);
  }
  void discard_output() noexcept override { bytes_->discard_output(); }
  bool set_dtr(bool on) noexcept override { return bytes_->set_dtr(on); }
  void shut_down() noexcept override { bytes_->shut_down(); }
  [[nodiscard]] int descriptor() const noexcept override { return bytes_->descriptor(); }
  [[nodiscard]] std::string_view name() const override { return bytes_->name(); }

 private:
  PortHandle port_;  ///< Holds the lock on the port.
  std::unique_ptr<FdTransport> bytes_;
};

/// What the last failed call of libserialport says, and what can be done about it.
tl::unexpected<Error> refused(const std::string& path, sp_return code, std::string_view deed) {
  const int error = errno;
  std::string reason = code == SP_ERR_ARG    ? "it is not a serial port of this machine"
                       : code == SP_ERR_SUPP ? "the adapter cannot do that"
                                             : std::strerror(error);
  if (code == SP_ERR_FAIL && error == EACCES) reason += "; add yourself to the group dialout";
  if (code == SP_ERR_FAIL && (error == EBUSY || error == EWOULDBLOCK)) {
    reason += "; another program uses it";
  }
  return fail(ErrorCode::kUnavailable, fmt::format("{}: cannot {}: {}", path, deed, reason));
}

sp_return configure(sp_port* port, int baud) {
  sp_return done = ::sp_set_baudrate(port, baud);
  if (done == SP_OK) done = ::sp_set_bits(port, 8);
  if (done == SP_OK) done = ::sp_set_parity(port, SP_PARITY_NONE);
  if (done == SP_OK) done = ::sp_set_stopbits(port, 1);
  if (done == SP_OK) done = ::sp_set_flowcontrol(port, SP_FLOWCONTROL_NONE);
  // Old bytes are answers to somebody else's questions.
  if (done == SP_OK) done = ::sp_flush(port, SP_BUF_BOTH);
  return done;
}

/// Whoever lets DTR fall when closing resets the board at the next opening, when it rises again.
sp_return keep_dtr_when_closed(int terminal) {
  termios settings{};
  if (::tcgetattr(terminal, &settings) < 0) return SP_ERR_FAIL;
  settings.c_cflag &= ~static_cast<tcflag_t>(HUPCL);
  return ::tcsetattr(terminal, TCSANOW, &settings) < 0 ? SP_ERR_FAIL : SP_OK;
}

}  // namespace

Result<std::unique_ptr<Transport>> open_serial(const std::string& path, int baud) {
  sp_port* found = nullptr;
  sp_return done = ::sp_get_port_by_name(path.c_str(), &found);
  if (done != SP_OK) return refused(path, done, "find it");
  PortHandle port(found);
  done = ::sp_open(port.get(), SP_MODE_READ_WRITE);
  if (done != SP_OK) return refused(path, done, "open it");
  int handle = -1;
  done = ::sp_get_port_handle(port.get(), &handle);
  if (done != SP_OK) return refused(path, done, "get its descriptor");
  done = keep_dtr_when_closed(handle);
  if (done != SP_OK) return refused(path, done, "keep its DTR");
  done = configure(port.get(), baud);
  if (done != SP_OK) return refused(path, done, fmt::format("set {} baud, 8N1", baud));
  // libserialport 0.1.1 leaves the port open for the programs that this one starts.
  if (::fcntl(handle, F_SETFD, FD_CLOEXEC) < 0) return refused(path, SP_ERR_FAIL, "keep it");
  UniqueFd fd(::fcntl(handle, F_DUPFD_CLOEXEC, 0));
  if (fd.get() < 0) return refused(path, SP_ERR_FAIL, "share its descriptor");
  auto bytes = FdTransport::adopt(std::move(fd), path);
  if (!bytes) return fail(bytes.error());
  return std::make_unique<SerialTransport>(std::move(port), *std::move(bytes));
}

}  // namespace slipstick
