// Faults, buttons and questions while the printer runs.
#include "sim/control.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/control_socket.h"
#include "sim/sim_options.h"
#include "tests/sim/dialogue.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

std::string control(Dialogue& dialogue, std::string_view line) {
  return obey_control(dialogue.printer(), line);
}

UniqueFd connect_to(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(static_cast<char*>(address.sun_path), path.size());
  UniqueFd fd(::socket(AF_UNIX, SOCK_STREAM, 0));
  REQUIRE(::connect(fd.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  return fd;
}

std::string answer(int fd) {
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(fd, buffer.data(), buffer.size());
  return count > 0 ? std::string(buffer.data(), static_cast<std::size_t>(count)) : std::string();
}

std::string shout(std::string_view line) {
  return "<" + std::string(line) + ">";
}

}  // namespace

TEST_CASE("A fault given while it runs is there at once, until it is mended") {
  Dialogue dialogue;
  dialogue.listen(100 * kSecond);

  CHECK(control(dialogue, "fault mute") == "ok");
  CHECK(dialogue.say("M105").empty());
  CHECK(control(dialogue, "mend") == "ok");
  CHECK_THAT(dialogue.say("M105"), Contains("ok T:"));
}

TEST_CASE("A live fault's time and line count from now") {
  Dialogue dialogue;
  dialogue.listen(100 * kSecond);
  dialogue.say("M105");

  CHECK(control(dialogue, "fault mute@2-3") == "ok");
  CHECK_FALSE(dialogue.say("M105", kSecond).empty());
  dialogue.listen(kSecond);
  CHECK(dialogue.say("M105").empty());
  dialogue.listen(kSecond);
  CHECK_FALSE(dialogue.say("M105").empty());

  CHECK(control(dialogue, "fault reset@line2") == "ok");
  CHECK_THAT(dialogue.say("M105", kSecond), !Contains("start"));
  CHECK_THAT(dialogue.say("M105", kSecond), Contains("start"));
}

TEST_CASE("A heater broken while it runs is whole again once mended") {
  Dialogue dialogue;
  CHECK(control(dialogue, "fault nozzle-open") == "ok");
  CHECK_THAT(dialogue.say("M105"), Contains("T:-15.00"));
  CHECK(control(dialogue, "mend") == "ok");
  CHECK_THAT(dialogue.say("M105"), Contains("T:22.00"));
}

TEST_CASE("There may be as many faults as there is room for; those that are over do not count") {
  Dialogue dialogue;
  for (int i = 0; i < 200; ++i) {
    REQUIRE(control(dialogue, "fault say=hello") == "ok");
    dialogue.listen(kSecond);
  }
  for (std::size_t i = 0; i < FaultSet::kMost; ++i)
    REQUIRE(control(dialogue, "fault late") == "ok");
  CHECK_THAT(control(dialogue, "fault late"), Contains("error: there are 64 faults"));
  CHECK(dialogue.printer().statistics().faults >= 200);
}

TEST_CASE("The buttons of the printer can be pressed") {
  Dialogue dialogue(sim_options({{"with", "filament-change"}})->printer);
  dialogue.say("M0");
  CHECK(control(dialogue, "press") == "ok");
  CHECK(dialogue.listen(kSecond) == "ok\n");

  CHECK(control(dialogue, "reset") == "ok");
  CHECK_THAT(dialogue.listen(kSecond), Contains("start\n External Reset\n"));
}

TEST_CASE("The state of the printer can be asked for") {
  Dialogue dialogue;
  dialogue.say("G28", 20 * kSecond);
  dialogue.say("G1 X30 Y5 F6000", 5 * kSecond);
  dialogue.say("M140 S50");

  const auto state = nlohmann::json::parse(control(dialogue, "state"));
  CHECK(state["x"] == 30);
  CHECK(state["bed_target"] == 50);
  CHECK(state["lines"] == 3);
  CHECK(state["halted"] == false);
}

TEST_CASE("What is no command is answered with those there are") {
  Dialogue dialogue;
  for (const char* line : {"", "fault", "fault ", "fault luck", "faults", "state now", "M105"}) {
    INFO(line);
    CHECK_THAT(control(dialogue, line), Catch::StartsWith("error: "));
  }
}

TEST_CASE("The control socket answers line by line, however they arrive") {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "control").string();
  auto socket = ControlSocket::open(path);
  REQUIRE(socket);
  const UniqueFd client = connect_to(path);
  socket->accept();

  REQUIRE(::send(client.get(), "one\ntw", 6, 0) == 6);
  socket->serve(shout);
  CHECK(answer(client.get()) == "<one>\n");
  REQUIRE(::send(client.get(), "o\nthree\n", 8, 0) == 8);
  socket->serve(shout);
  CHECK(answer(client.get()) == "<two>\n<three>\n");
}

TEST_CASE("A line without an end, and a newer client, end a control connection") {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "control").string();
  auto socket = ControlSocket::open(path);
  REQUIRE(socket);
  const UniqueFd first = connect_to(path);
  socket->accept();
  const std::string endless(ControlSocket::kLineMax, 'a');
  REQUIRE(::send(first.get(), endless.data(), endless.size(), 0) > 0);
  socket->serve(shout);
  CHECK(answer(first.get()).empty());
  CHECK(socket->client() == -1);

  const UniqueFd second = connect_to(path);
  socket->accept();
  const UniqueFd third = connect_to(path);
  socket->accept();
  CHECK(answer(second.get()).empty());
}

TEST_CASE("A control socket left over is replaced, one in use and other files are not") {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "control").string();
  {
    const UniqueFd dead(::socket(AF_UNIX, SOCK_STREAM, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(static_cast<char*>(address.sun_path), path.size());
    REQUIRE(::bind(dead.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  }
  auto socket = ControlSocket::open(path);
  REQUIRE(socket);
  CHECK_FALSE(ControlSocket::open(path));
  CHECK(std::filesystem::is_socket(path));
  CHECK_FALSE(ControlSocket::open(folder.path().string()));
  const auto too_long = ControlSocket::open(std::string(200, 'x'));
  REQUIRE_FALSE(too_long);
  CHECK(too_long.error().code == ErrorCode::kInput);
}
