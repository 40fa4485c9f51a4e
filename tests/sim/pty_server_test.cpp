#include "sim/pty_server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <thread>

using namespace slipstick;

namespace {

/// Far more than anything here takes; only a failure waits so long.
constexpr int kPatienceMs = 5'000;

/// A folder of its own that goes away with it.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "slipstick-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Reads until `end` came or patience is over.
std::string read_until(int fd, std::string_view end) {
  std::string text;
  std::array<char, 256> buffer{};
  while (text.find(end) == std::string::npos) {
    pollfd waiting{fd, POLLIN, 0};
    if (::poll(&waiting, 1, kPatienceMs) <= 0) break;
    const ssize_t count = ::read(fd, buffer.data(), buffer.size());
    if (count <= 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

void write_text(int fd, std::string_view text) {
  REQUIRE(::write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
}

/// A server that runs as long as this lives.
class Running {
 public:
  explicit Running(const PtyServerOptions& options, const PrinterOptions& printer = {})
      : server_(PtyServer::open(options, Printer(printer))) {
    REQUIRE(server_);
    thread_ = std::jthread([this](const std::stop_token& stop) { failed_ = !server_->run(stop); });
  }
  ~Running() {
    thread_.request_stop();
    thread_.join();
    CHECK_FALSE(failed_);
  }
  [[nodiscard]] const PtyServer& server() const { return *server_; }

 private:
  Result<PtyServer> server_;
  bool failed_ = false;
  std::jthread thread_;
};

}  // namespace

TEST_CASE("A host program talks to the printer through the link to its terminal") {
  const Folder folder;
  const Running running({.pty_path = folder.file("printer"), .tcp_port = std::nullopt});
  const UniqueFd fd(::open(folder.file("printer").c_str(), O_RDWR | O_NOCTTY));
  REQUIRE(fd.valid());

  CHECK(read_until(fd.get(), "D114.00\n").find("start\n") != std::string::npos);
  write_text(fd.get(), "N1 M115*39\n");
  const std::string reply = read_until(fd.get(), "ok\n");

  CHECK(reply.starts_with("FIRMWARE_NAME:Marlin 2.1.2"));
  CHECK(reply.ends_with("Cap:CONFIG_EXPORT:0\nok\n"));
}

TEST_CASE("Its control socket does things to the printer while a host talks to it") {
  const Folder folder;
  const Running running({.pty_path = folder.file("printer"),
                         .tcp_port = std::nullopt,
                         .control_path = folder.file("control")});
  const UniqueFd host(::open(folder.file("printer").c_str(), O_RDWR | O_NOCTTY));
  REQUIRE(host.valid());
  read_until(host.get(), "D114.00\n");
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  folder.file("control").copy(static_cast<char*>(address.sun_path), sizeof address.sun_path - 1);
  const UniqueFd fd(::socket(AF_UNIX, SOCK_STREAM, 0));
  REQUIRE(::connect(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);

  write_text(fd.get(), "fault say=// hello\n");

  CHECK(read_until(fd.get(), "\n") == "ok\n");
  CHECK(read_until(host.get(), "\n") == "// hello\n");
}

TEST_CASE("A TCP connection resets the board and gets its banner") {
  const Running running({.pty_path = "", .tcp_port = 0});
  const UniqueFd fd(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(running.server().tcp_port()));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);

  REQUIRE(::connect(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
  CHECK(read_until(fd.get(), "D114.00\n").starts_with("start\n"));
  write_text(fd.get(), "M110 N5\n");

  CHECK(read_until(fd.get(), "ok\n") == "ok\n");
}

TEST_CASE("The link goes away with the server, and one left behind is replaced") {
  const Folder folder;
  const std::string path = folder.file("printer");
  std::filesystem::create_symlink("/dev/pts/99999", path);
  {
    const Running running({.pty_path = path, .tcp_port = std::nullopt});
    CHECK(std::filesystem::read_symlink(path).string() == running.server().device());
  }
  CHECK_FALSE(std::filesystem::is_symlink(path));
}

TEST_CASE("A pulled cable takes the terminal away; when it is back there is another one") {
  const Folder folder;
  const std::string path = folder.file("printer");
  PrinterOptions options;
  options.faults = {FaultSpec::parse("unplug=0.2@line1").value()};
  const Running running({.pty_path = path, .tcp_port = std::nullopt}, options);
  const UniqueFd before(::open(path.c_str(), O_RDWR | O_NOCTTY));
  read_until(before.get(), "D114.00\n");
  write_text(before.get(), "M117\n");

  read_until(before.get(), "never");  // Ends where the terminal does.
  UniqueFd after;
  for (int i = 0; !after.valid() && i < kPatienceMs; ++i) {
    ::poll(nullptr, 0, 1);
    after = UniqueFd(::open(path.c_str(), O_RDWR | O_NOCTTY));
  }

  REQUIRE(after.valid());
  write_text(after.get(), "M117\n");
  CHECK(read_until(after.get(), "ok\n") == "ok\n");
}

TEST_CASE("A path that is something else is left alone") {
  const Folder folder;
  std::filesystem::create_directory(folder.file("printer"));

  const auto server =
      PtyServer::open({.pty_path = folder.file("printer"), .tcp_port = std::nullopt}, Printer({}));

  REQUIRE_FALSE(server);
  CHECK(server.error().code == ErrorCode::kUnavailable);
  CHECK(std::filesystem::is_directory(folder.file("printer")));
}

TEST_CASE("The printer's clock may run faster than ours") {
  const Folder folder;
  const std::string path = folder.file("printer");
  const Running running({.pty_path = path, .tcp_port = std::nullopt, .speed = 1000});
  const UniqueFd fd(::open(path.c_str(), O_RDWR | O_NOCTTY));
  read_until(fd.get(), "D114.00\n");

  write_text(fd.get(), "G4 S600\n");  // Far beyond our patience.

  CHECK(read_until(fd.get(), "ok\n").ends_with("ok\n"));
}

TEST_CASE("A clock that stands or flies is a mistake") {
  const Folder folder;
  for (const double speed : {0.0, -1.0, 1e9}) {
    const auto server = PtyServer::open(
        {.pty_path = folder.file("printer"), .tcp_port = std::nullopt, .speed = speed},
        Printer({}));
    REQUIRE_FALSE(server);
    CHECK(server.error().code == ErrorCode::kInput);
  }
}

TEST_CASE("A server with nothing to open is a mistake") {
  const auto server = PtyServer::open({}, Printer({}));

  REQUIRE_FALSE(server);
  CHECK(server.error().code == ErrorCode::kInput);
}
