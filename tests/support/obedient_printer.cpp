#include "tests/support/obedient_printer.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <optional>

#include "core/base/check.h"

namespace slipstick::test {
namespace {

constexpr int kLookMilliseconds = 20;

bool readable(int fd) {
  pollfd look{fd, POLLIN, 0};
  return ::poll(&look, 1, kLookMilliseconds) > 0;
}

// "N12 G28*45" says G28.
std::string command_of(std::string line) {
  line = line.substr(0, line.rfind('*'));
  if (!line.empty() && line[0] == 'N')
    line = line.substr(std::min(line.find(' '), line.size() - 1) + 1);
  return line;
}

std::string answer_to(const std::string& command) {
  if (command.starts_with("M115")) return "FIRMWARE_NAME:Marlin 2.1.2\nok\n";
  if (command.starts_with("M105")) return "ok T:20.0 /0.0 B:20.0 /0.0\n";
  return "ok\n";
}

}  // namespace

ObedientPrinter::ObedientPrinter() : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* raw = reinterpret_cast<sockaddr*>(&address);
  SLIPSTICK_CHECK(::bind(listener_.get(), raw, size) == 0);
  SLIPSTICK_CHECK(::listen(listener_.get(), 8) == 0);
  SLIPSTICK_CHECK(::getsockname(listener_.get(), raw, &size) == 0);
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { run(); });
}

ObedientPrinter::~ObedientPrinter() {
  ending_ = true;
  thread_.join();
}

std::string ObedientPrinter::address() const {
  return "tcp:127.0.0.1:" + std::to_string(port_);
}

std::vector<std::string> ObedientPrinter::commands() const {
  const std::lock_guard lock(mutex_);
  return commands_;
}

std::size_t ObedientPrinter::count() const {
  const std::lock_guard lock(mutex_);
  return commands_.size();
}

void ObedientPrinter::run() {
  while (!ending_) {
    if (!readable(listener_.get())) continue;
    const UniqueFd connection(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
    if (connection.valid()) serve(connection.get());
  }
}

void ObedientPrinter::serve(int connection) {
  std::string pending;
  char bytes[4096];
  static_cast<void>(::send(connection, "start\n", 6, MSG_NOSIGNAL));  // as after a reset
  while (!ending_) {
    if (!readable(connection)) continue;
    const ssize_t got = ::recv(connection, bytes, sizeof bytes, 0);
    if (got <= 0) return;
    pending.append(bytes, static_cast<std::size_t>(got));
    for (std::size_t end = 0; (end = pending.find('\n')) != pending.npos;) {
      const std::string command = command_of(pending.substr(0, end));
      pending.erase(0, end + 1);
      if (command.empty()) continue;
      {
        const std::lock_guard lock(mutex_);
        commands_.push_back(command);
      }
      const std::string answer = answer_to(command);
      // Whoever has gone in the meantime is obeyed all the same.
      static_cast<void>(::send(connection, answer.data(), answer.size(), MSG_NOSIGNAL));
    }
  }
}

}  // namespace slipstick::test
