// Programs and web addresses that are told of what happens to a printer.
#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "host/serve/hook.h"
#include "host/serve/hook_program.h"
#include "tests/support/child_process.h"
#include "tests/support/http_client.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/web_listener.h"

using namespace slipstick;
using Catch::Contains;
using Catch::StartsWith;
using nlohmann::json;

namespace {

EventLog::Event state(const std::string& name, int job, int layer = 0) {
  nlohmann::ordered_json said{{"state", name}, {"job", nullptr}};
  if (job != 0) said["job"] = {{"id", job}, {"layer", layer}};
  return {1, "state", said.dump()};
}

std::string names(OccasionFinder& finder, const EventLog::Event& event) {
  std::string text;
  for (const Occasion& occasion : finder.occasions(event)) {
    CHECK(occasion.told["event"] == name_of(occasion.kind));
    text.append(text.empty() ? "" : " ").append(name_of(occasion.kind));
  }
  return text;
}

class Scripts {
 public:
  // A program that writes its argument and its input behind each other.
  std::string recorder(const std::string& name) const {
    return script(name, "{ echo \"$1\"; cat; echo; } >>" + path(name + ".log"));
  }
  std::string script(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << "#!/bin/sh\n" << text << "\n";
    std::filesystem::permissions(path(name), std::filesystem::perms::owner_all);
    return path(name);
  }
  [[nodiscard]] std::string log_of(const std::string& name) const {
    std::stringstream text;
    text << std::ifstream(path(name + ".log")).rdbuf();
    return text.str();
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

 private:
  test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("What happens is found once in what is told of a printer") {
  OccasionFinder finder;
  CHECK(names(finder, state("idle", 0)).empty());
  CHECK(names(finder, state("printing", 7)) == "started");
  CHECK(names(finder, state("printing", 7, 1)) == "layer");
  CHECK(names(finder, state("printing", 7, 1)).empty());
  CHECK(names(finder, state("paused", 7, 1)) == "paused");
  CHECK(names(finder, state("printing", 7, 3)) == "layer resumed");
  CHECK(names(finder, {1, "log", R"({"text": "done"})"}).empty());
  CHECK(names(finder, {1, "jobs", R"({"id": 8, "state": "queued"})"}).empty());
  CHECK(names(finder, {1, "jobs", R"({"id": 7, "state": "done"})"}) == "done");
  CHECK(names(finder, state("idle", 0)).empty());
  CHECK(names(finder, state("printing", 8, 1)) == "started layer");
  CHECK(names(finder, {1, "jobs", R"({"id": 8, "state": "failed"})"}) == "failed");
  CHECK(names(finder, state("stopped", 0)) == "stopped");
}

TEST_CASE("A hook has an event and a web address or a program that is there") {
  const Scripts scripts;
  const std::string program = scripts.recorder("a");
  CHECK(parse_hook("layer=http://10.0.0.7:8080/snap?x=1"));
  CHECK(parse_hook("done=" + program)->on == OccasionKind::kDone);
  for (const std::string text : {"", "done", "=", "finished=http://a", "done=a.sh",
                                 "done=file:///x", "done=/nowhere/a", "done="}) {
    INFO(text);
    const auto hook = parse_hook(text);
    REQUIRE_FALSE(hook);
    CHECK_THAT(hook.error().message, Contains("--hook"));
  }
  const auto served =
      test::slipstick({"serve", "--data", scripts.path("data"), "--hook", "done=x"});
  CHECK(served.status == 1);
  CHECK_THAT(served.err, Contains("--hook: 'x'"));
}

TEST_CASE("A program gets the name and the facts, and no shell sees them") {
  const Scripts scripts;
  const auto told = [](const std::string& program) {
    return HookTarget::from(program)->tell("layer", {{"event", "layer"}, {"file", "a \xff.lua"}});
  };

  CHECK(told(scripts.recorder("a")));

  CHECK(scripts.log_of("a") == "layer\n{\"event\":\"layer\",\"file\":\"a \xef\xbf\xbd.lua\"}\n");
  CHECK_THAT(told(scripts.script("b", "exit 3")).error().message, Contains("/b: status 3"));
  CHECK_THAT(told(scripts.script("c", "kill -9 $$")).error().message, Contains("/c: signal 9"));
}

TEST_CASE("A program that does not end is killed with its children") {
  const Scripts scripts;
  const std::string program =
      scripts.script("a", "sleep 1000 & echo $! >" + scripts.path("child") + "; wait");
  const auto child = [&] {
    pid_t process = 0;
    std::ifstream(scripts.path("child")) >> process;
    return process;
  };

  CHECK_THAT(run_program(program, "layer", "", std::chrono::seconds(1)).error().message,
             Contains("/a: killed after 1000 ms"));

  REQUIRE(child() > 1);
  // It may lie there unburied, but it does not run.
  const auto dead = [&] {
    std::stringstream text;
    text << std::ifstream("/proc/" + std::to_string(child()) + "/status").rdbuf();
    return text.str().empty() || text.str().find("State:\tZ") != std::string::npos;
  };
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!dead() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  CHECK(dead());
}

TEST_CASE("A print begins when its power supply is on, and not at all where it is not") {
  const Scripts scripts;
  const auto ended = [&](const std::string& program) {
    test::ChildProcess daemon({"serve", "--data", scripts.path("data"), "--listen", "127.0.0.1:0",
                               "--printer", "sim:", "--power-on", program, "--hook",
                               "done=" + scripts.recorder("end"), "--hook",
                               "failed=" + scripts.recorder("end")});
    const std::string line = daemon.line();
    const auto port = static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
    REQUIRE(test::request(port, "PUT", "/api/v1/files/a.gcode", "G1 X1\n").status == 201);
    REQUIRE(test::request(port, "POST", "/api/v1/printer/bed-cleared").status == 204);
    REQUIRE(test::request(port, "POST", "/api/v1/jobs", R"({"file": "a.gcode"})").status == 201);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (scripts.log_of("end").empty() && std::chrono::steady_clock::now() < end) {
      std::this_thread::yield();
    }
    daemon.send(SIGTERM);
    CHECK(daemon.wait() == 0);
    const std::string log = scripts.log_of("end");
    std::filesystem::remove(scripts.path("end.log"));
    return log;
  };

  CHECK_THAT(ended(scripts.recorder("power")), StartsWith("done\n"));
  CHECK(scripts.log_of("power") == "power-on\n{\"job\":1,\"file\":\"a.gcode\"}\n");
  CHECK_THAT(ended(scripts.script("no", "exit 1")),
             StartsWith("failed\n") && Contains("power supply") && Contains("/no: status 1"));
}

TEST_CASE("A print tells its hooks from its start to its end") {
  const Scripts scripts;
  test::WebListener web;
  std::vector<std::string> words{"serve",       "--data", scripts.path("data"), "--listen",
                                 "127.0.0.1:0", "--hook", "done=" + web.url()};
  for (const char* event : {"started", "layer", "cancelled"}) {
    words.insert(words.end(), {"--hook", std::string(event) + "=" + scripts.recorder("a")});
  }
  words.insert(words.end(), {"--printer", "sim:"});
  test::ChildProcess daemon(words);
  const std::string line = daemon.line();
  const auto port = static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
  const std::string ball = "return sphere(2)\n";
  REQUIRE(test::request(port, "PUT", "/api/v1/files/ball.lua", ball).status == 201);
  REQUIRE(test::request(port, "POST", "/api/v1/jobs", R"({"file": "ball.lua"})").status == 201);

  const std::string told = web.request("204 No Content");

  CHECK_THAT(told, Contains("POST /hook HTTP/1.1") && Contains("Content-Type: application/json"));
  const json facts = json::parse(told.substr(told.find("\r\n\r\n")));
  CHECK(
      facts ==
      json{{"event", "done"}, {"id", 1}, {"file", "ball.lua"}, {"state", "done"}, {"message", ""}});
  daemon.send(SIGTERM);
  CHECK(daemon.wait() == 0);
  const std::string log = scripts.log_of("a");
  CHECK(log.starts_with("started\n"));
  CHECK_THAT(log, Contains("\nlayer\n") && !Contains("cancelled"));
}
