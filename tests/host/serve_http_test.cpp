// The daemon over sockets: what clients send, and what none should.
#include <catch2/catch.hpp>
#include <chrono>

#include "tests/host/serve_fixture.h"

using namespace slipstick;
using Catch::Contains;

namespace {

std::string lua() {
  return test::example("bracket.lua");
}

}  // namespace

TEST_CASE("Files are stored, listed, replaced and removed") {
  const test::RunningDaemon daemon;

  CHECK(daemon.put("/api/v1/files/W%C3%BCrfel%20a.lua", lua()).status == 201);
  CHECK(daemon.put("/api/v1/files/W%C3%BCrfel%20a.lua", "another").status == 201);

  const auto listed = test::json_of(daemon.get("/api/v1/files"));
  REQUIRE(listed["files"].size() == 1);
  CHECK(listed["files"][0]["name"] == "W\xc3\xbcrfel a.lua");
  CHECK(listed["files"][0]["size"] == 7);
  CHECK(daemon.get("/api/v1/files/W%C3%BCrfel%20a.lua").status == 200);
  CHECK(daemon.remove("/api/v1/files/W%C3%BCrfel%20a.lua").status == 204);
  CHECK(daemon.remove("/api/v1/files/W%C3%BCrfel%20a.lua").status == 404);
  CHECK(daemon.get("/api/v1/files/W%C3%BCrfel%20a.lua").status == 404);
}

TEST_CASE("Any layer of a model is sliced on the spot") {
  const test::RunningDaemon daemon;
  REQUIRE(daemon.put("/api/v1/files/part.lua", lua()).status == 201);

  const auto about = test::json_of(daemon.get("/api/v1/files/part.lua/layers"));
  const auto layer = test::json_of(daemon.get("/api/v1/files/part.lua/layers/10"));
  const auto coarse = test::json_of(daemon.get(
      "/api/v1/files/part.lua/layers?spec=%7B%22settings%22%3A%7B%22layer_height%22%3A0.4%7D%7D"));

  CHECK(about["layers"] == 150);
  CHECK(coarse["layers"] == 75);
  CHECK(layer["layer"] == 10);
  CHECK(layer["loops"].size() >= 1);
  CHECK(daemon.get("/api/v1/files/part.lua/layers/150").status == 400);
  CHECK(daemon.get("/api/v1/files/part.lua/layers/-1").status == 400);
  CHECK(daemon.get("/api/v1/files/part.lua/layers/x").status == 400);
  CHECK(daemon.get("/api/v1/files/part.lua/layers/2147483647").status == 400);
  CHECK(daemon.get("/api/v1/files/none.lua/layers/1").status == 404);
  CHECK(daemon.get("/api/v1/files/part.lua/layers?spec=%7B").status == 400);
}

TEST_CASE("No name leads out of the data folder") {
  const test::RunningDaemon daemon;

  for (const char* name : {"..%2f..%2fa.lua", "%2e%2e", "..%5ca.lua", "a%00.lua", ".hidden.lua",
                           "%2fetc%2fa.lua", "a.lua%2f..%2fb.lua"}) {
    INFO(name);
    CHECK(daemon.put(std::string("/api/v1/files/") + name, lua()).status == 400);
    CHECK(daemon.get(std::string("/api/v1/files/") + name).status == 404);
  }
  CHECK(daemon.get("/api/v1/../../etc/passwd").status == 404);
  CHECK(test::json_of(daemon.get("/api/v1/files"))["files"].empty());
}

TEST_CASE("Wrong requests are answered with what is wrong with them") {
  const test::RunningDaemon daemon;
  REQUIRE(daemon.put("/api/v1/files/part.lua", lua()).status == 201);

  CHECK(daemon.get("/nothing").status == 404);
  CHECK(daemon.post("/api/v1/files").status == 405);
  CHECK(daemon.post("/api/v1/files").headers.at("allow") == "GET");
  CHECK(daemon.put("/api/v1/files/page.html", "<html>").status == 400);
  CHECK(daemon.put("/api/v1/files/empty.lua", "").status == 400);
  for (const char* body : {"", "{", "[]", "null", "\xff", R"({"file": 7})", R"({"spec": {}})",
                           R"({"file": "part.lua", "spec": {"settings": {"x": 1}}})",
                           R"({"file": "part.lua", "surprise": 1})"}) {
    INFO(body);
    const auto reply = daemon.post("/api/v1/jobs", body);
    CHECK((reply.status == 400 || reply.status == 404));
    CHECK(!test::json_of(reply)["error"].get<std::string>().empty());
  }
  CHECK(daemon.post("/api/v1/jobs", std::string(100'000, '[')).status == 400);
  CHECK(daemon.get("/api/v1/jobs/99").status == 404);
  CHECK(daemon.get("/api/v1/jobs/9999999999999999999").status == 404);
  CHECK(daemon.post("/api/v1/jobs/99/cancel").status == 404);
  CHECK(test::json_of(daemon.get("/api/v1/jobs"))["jobs"].empty());
}

TEST_CASE("What is too large is refused, and the daemon goes on") {
  const test::RunningDaemon daemon;

  CHECK(daemon.post("/api/v1/jobs", std::string((1 << 20) + 1, ' ')).status == 413);
  CHECK(test::request(daemon.port(), "GET", "/api/v1/jobs", "",
                      "X-Long: " + std::string(20'000, 'a') + "\r\n")
            .status == 431);
  CHECK(daemon.get("/" + std::string(5000, 'a')).status == 400);
  test::HttpClient huge(daemon.port());
  huge.send(
      "PUT /api/v1/files/a.lua HTTP/1.1\r\nHost: localhost\r\nContent-Length: 2000000000\r\n\r\n");
  CHECK(huge.reply().status == 413);
  CHECK(daemon.get("/api/v1/jobs").status == 200);
}

TEST_CASE("Bytes that are no request end in a refusal or an end, never in more") {
  const test::RunningDaemon daemon;

  for (const std::string_view bytes :
       {std::string_view("\x16\x03\x01\x02\x00\x01\x00", 7), std::string_view("GET\r\n\r\n"),
        std::string_view("GET / HTTP/9.9\r\n\r\n"), std::string_view("\0\0\0\0\r\n\r\n", 8),
        std::string_view(
            "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Length: -1\r\n\r\n"),
        std::string_view("POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\n"
                         "Transfer-Encoding: chunked\r\n\r\nzz\r\n")}) {
    test::HttpClient client(daemon.port());
    client.send(bytes);
    const int status = client.reply().status;
    CHECK((status == 0 || status == 400));
  }
  CHECK(daemon.get("/api/v1/jobs").status == 200);
}

TEST_CASE("A connection serves several requests, also after a refusal") {
  const test::RunningDaemon daemon;
  test::HttpClient client(daemon.port());
  const std::string head = " HTTP/1.1\r\nHost: localhost\r\n\r\n";

  client.send("GET /api/v1/jobs" + head + "GET /nothing" + head + "GET /api/v1/printer" + head);

  CHECK(client.reply().status == 200);
  CHECK(client.reply().status == 404);
  CHECK(test::json_of(client.reply())["state"] == "idle");
}

TEST_CASE("A client that asks first is told to go on; an upload that breaks off leaves nothing") {
  const test::RunningDaemon daemon;
  {
    test::HttpClient client(daemon.port());
    client.send(
        "PUT /api/v1/files/a.lua HTTP/1.1\r\nHost: localhost\r\nContent-Length: 6\r\n"
        "Expect: 100-continue\r\n\r\n");
    CHECK(client.reply().status == 100);
    client.send("return");
    CHECK(client.reply().status == 201);
  }
  {
    test::HttpClient client(daemon.port());
    client.send(
        "PUT /api/v1/files/b.lua HTTP/1.1\r\nHost: localhost\r\nContent-Length: 60\r\n"
        "Expect: 100-continue\r\n\r\n");
    CHECK(client.reply().status == 100);
    client.send("half");
  }

  CHECK(test::json_of(daemon.get("/api/v1/files"))["files"].size() == 1);
}

TEST_CASE("The page and all it is made of are there, and may load nothing from elsewhere") {
  const test::RunningDaemon daemon;

  const auto page = daemon.get("/");
  CHECK(page.status == 200);
  CHECK_THAT(page.headers.at("content-type"), Contains("text/html"));
  CHECK_THAT(page.headers.at("content-security-policy"), Contains("default-src 'none'"));
  CHECK(page.headers.at("x-content-type-options") == "nosniff");
  CHECK(page.body.find("<script>") == page.body.npos);
  CHECK(page.body.find("onclick") == page.body.npos);
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SLIPSTICK_SOURCE_DIR) + "/host/web")) {
    if (entry.path().extension() == ".cmake") continue;
    INFO(entry.path());
    const auto asset = daemon.get("/assets/" + entry.path().filename().string());
    std::ifstream file(entry.path());
    CHECK(asset.body == std::string(std::istreambuf_iterator<char>(file), {}));
    CHECK(asset.body.find("innerHTML") == asset.body.npos);
  }
  CHECK(daemon.get("/assets/..%2fembed.cmake").status == 404);
  CHECK(daemon.get("/assets/embed.cmake").status == 404);
}

TEST_CASE("Off this machine a key is needed, for everything") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey);
  REQUIRE(daemon.key().size() == 64);
  const std::string shown = "X-Api-Key: " + daemon.key() + "\r\n";

  CHECK(daemon.get("/api/v1/printer").status == 401);
  CHECK(daemon.get("/api/v1/events").status == 401);
  CHECK(daemon.get("/").status == 200);  // the page leads to the login
  CHECK(daemon.put("/api/v1/files/a.lua", lua()).status == 401);
  CHECK(test::request(daemon.port(), "GET", "/api/v1/printer", "", shown).status == 200);
  const auto mode = std::filesystem::status(daemon.data() / "api_key").permissions();
  CHECK((mode & std::filesystem::perms(0777)) == std::filesystem::perms(0600));
}

TEST_CASE("A second daemon does not get the data of the first") {
  const test::RunningDaemon daemon;
  Daemon::Options options;
  options.data = daemon.data();
  options.listen = "127.0.0.1:0";
  options.port = "sim:";

  const auto second = Daemon::start(options);

  REQUIRE(!second);
  CHECK_THAT(second.error().message, Contains("in use"));
}

TEST_CASE("Mistakes in how the daemon is started are told at the start") {
  const test::TemporaryFolder folder;
  Daemon::Options options;
  options.data = folder.path();
  options.listen = "127.0.0.1:0";
  options.port = "sim:";
  const auto fault = [](const Daemon::Options& wrong) {
    const auto daemon = Daemon::start(wrong);
    return daemon ? "" : daemon.error().message;
  };

  auto wrong = options;
  wrong.listen = "printer";
  CHECK_THAT(fault(wrong), Contains("127.0.0.1:5000"));
  wrong = options;
  wrong.port = "cable";
  CHECK(!fault(wrong).empty());
  wrong = options;
  wrong.defaults.printer = "nobody";
  CHECK_THAT(fault(wrong), Contains("nobody"));
  wrong = options;
  wrong.camera = "rtsp://camera";
  CHECK_THAT(fault(wrong), Contains("camera") && Contains("http://"));
  wrong = options;
  wrong.data = "/proc/nowhere";
  CHECK_THAT(fault(wrong), Contains("/proc/nowhere"));
}

TEST_CASE("All settings are told, with their values and what they are for") {
  const test::RunningDaemon daemon;

  const auto settings = test::json_of(daemon.get("/api/v1/settings"))["settings"];

  CHECK(settings.size() > 50);
  for (const auto& setting : settings) CHECK(!setting["help"].get<std::string>().empty());
}
