#include "tests/support/daemon_process.h"

#include "core/base/check.h"

namespace slipstick::test {

DaemonProcess::DaemonProcess(const std::filesystem::path& data, const std::string& printer)
    : process_(
          {"serve", "--data", data.string(), "--listen", "127.0.0.1:0", "--printer", printer}) {
  const std::string line = process_.line();
  SLIPSTICK_CHECK(line.find("listening on http://127.0.0.1:") == 0);
  port_ = static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
}

int DaemonProcess::end(int signal) {
  process_.send(signal);
  return process_.wait();
}

}  // namespace slipstick::test
