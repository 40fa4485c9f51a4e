#pragma once

#include <chrono>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "drivers/unique_fd.h"
#include "sim/control_socket.h"
#include "sim/printer.h"

namespace slipstick {

struct PtyServerOptions {
  std::string pty_path;           ///< Where the link to the pseudo-terminal is made; empty is none.
  std::optional<int> tcp_port;    ///< On 127.0.0.1; 0 lets the system choose.
  double speed = 1;               ///< Seconds of the printer in one of the host's, 0.01 to 1000.
  std::string control_path = {};  ///< Of a socket for control.h; empty is none.
};

/// A printer in real time, or so many times as fast, for any host program: behind a
/// pseudo-terminal, a TCP port or both.
///
/// Both lead to the one serial port of the board: it hears whoever speaks and all hear it. A TCP
/// connection resets the board, as opening the port of an Arduino does; a newer one replaces an
/// older one. What the board says while nobody listens is lost once the terminal's buffer is full.
/// While the cable is out there is neither terminal nor link, and no connection.
class PtyServer {
 public:
  /// Opens what `options` ask for. The link to the terminal goes away with the server.
  ///
  /// \return kInput if nothing is asked for, or a speed that cannot be; kUnavailable if the link's
  /// path exists and is not such a link, the port or the control socket is taken, or the system has
  /// no terminal left.
  [[nodiscard]] static Result<PtyServer> open(const PtyServerOptions& options, Printer printer);

  PtyServer(PtyServer&&) noexcept = default;
  PtyServer& operator=(PtyServer&&) = delete;
  ~PtyServer();

  /// Runs the printer until `stop` is requested (from any thread, at once). One thread.
  [[nodiscard]] Result<void> run(const std::stop_token& stop);

  /// The device behind the link: "/dev/pts/3"; empty without one.
  [[nodiscard]] const std::string& device() const { return device_; }
  /// Where TCP clients connect; 0 without.
  [[nodiscard]] int tcp_port() const { return tcp_port_; }
  /// \pre `run` is not running.
  [[nodiscard]] const Printer& printer() const { return printer_; }

 private:
  PtyServer(Printer printer, double speed) : printer_(std::move(printer)), speed_(speed) {}

  [[nodiscard]] Result<void> open_terminal(const std::string& path);
  [[nodiscard]] Result<void> listen_on(int port);
  [[nodiscard]] Result<void> wait(int stop_fd, Moment elapsed);
  /// Takes the terminal away when the cable is pulled out, and makes a new one when it is back.
  [[nodiscard]] Result<void> follow_cable();
  void close_terminal();
  void accept_client();
  void hear(int fd, Moment elapsed);
  void speak();

  Printer printer_;
  double speed_;
  UniqueFd terminal_;       ///< The master side.
  UniqueFd terminal_held_;  ///< The other side, held open so that the terminal outlives its users.
  UniqueFd listener_;
  UniqueFd client_;
  std::optional<ControlSocket> control_;
  std::string device_;
  std::string link_;  ///< Removed at the end if it still leads to `device_`.
  bool cable_in_ = true;
  int tcp_port_ = 0;
};

}  // namespace slipstick
