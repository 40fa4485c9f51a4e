// What becomes of a port's descriptors beside this program.
#include <fcntl.h>
#include <stdlib.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "drivers/pty_transport.h"
#include "drivers/unique_fd.h"

namespace slipstick {
namespace {

std::set<int> descriptors() {
  std::set<int> open;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    open.insert(std::stoi(entry.path().filename().string()));
  }
  // The one that the folder was read by is closed again.
  std::erase_if(open, [](int fd) { return ::fcntl(fd, F_GETFD) < 0; });
  return open;
}

TEST_CASE("Programs that this one starts inherit no port") {
  const UniqueFd master(::posix_openpt(O_RDWR | O_NOCTTY));
  REQUIRE((::grantpt(master.get()) == 0 && ::unlockpt(master.get()) == 0));
  const std::set<int> before = descriptors();

  const auto port = open_pty(::ptsname(master.get()));

  REQUIRE(port);
  std::size_t opened = 0;
  for (const int fd : descriptors()) {
    if (before.contains(fd)) continue;
    ++opened;
    CHECK((::fcntl(fd, F_GETFD) & FD_CLOEXEC) != 0);
  }
  CHECK(opened == 2);
}

}  // namespace
}  // namespace slipstick
