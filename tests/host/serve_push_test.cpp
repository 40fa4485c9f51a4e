// OctoPrint's push socket over sockets: what apps hear, and what no client should send.
#include <catch2/catch.hpp>

#include "host/serve/push_client.h"
#include "tests/host/guarded_daemon.h"
#include "tests/host/serve_fixture.h"
#include "tests/support/web_socket.h"

using namespace slipstick;
using namespace std::chrono_literals;
using nlohmann::json;
using test::frame_bytes;
using test::WebSocketClient;

namespace {

constexpr const char* kRaw = "/sockjs/websocket";
constexpr const char* kSockJs = "/sockjs/042/x9zr1k2p/websocket";
constexpr int kPolicy = 1008, kTooBig = 1009, kTryLater = 1013;

HttpLimits limits_with(std::chrono::milliseconds head, std::chrono::milliseconds push,
                       int streams) {
  HttpLimits limits;
  limits.head_patience = head;
  limits.push_patience = push;
  limits.streams = streams;
  return limits;
}

/// "history", or of an event its type; empty at the end.
std::string kind_of(const std::string& message) {
  const json parsed = json::parse(message);
  const std::string key = parsed.items().begin().key();
  return key == "event" ? parsed["event"]["type"].get<std::string>() : key;
}

/// The next message of that kind; null at the end.
json wait_for(WebSocketClient& client, const std::string& kind) {
  while (const auto text = client.text()) {
    if (kind_of(*text) == kind) return json::parse(*text);
  }
  return {};
}

std::string next_kind(WebSocketClient& client) {
  const auto text = client.text();
  return text ? kind_of(*text) : "";
}

std::string key_of(const test::RunningDaemon& daemon) {
  return "X-Api-Key: " + daemon.key() + "\r\n";
}

/// The `auth` message that a passive login makes possible.
std::string auth_of(const test::RunningDaemon& daemon) {
  const json login = test::json_of(
      test::request(daemon.port(), "POST", "/api/login", R"({"passive": true})", key_of(daemon)));
  return json{
      {"auth", login["name"].get<std::string>() + ":" + login["session"].get<std::string>()}}
      .dump();
}

}  // namespace

TEST_CASE("An app hears what this is, the state, and a print from end to end") {
  const test::RunningDaemon daemon;
  WebSocketClient app(daemon.port(), kRaw);
  REQUIRE(app.is_open());

  CHECK(next_kind(app) == "connected");
  const json history = wait_for(app, "history")["history"];
  CHECK(history["state"]["text"] == "Operational");
  REQUIRE(daemon.put("/api/v1/files/a.gcode", "G90\nG28\nM400\n").status == 201);
  CHECK(wait_for(app, "FileAdded")["event"]["payload"]["name"] == "a.gcode");
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "a.gcode"})").status == 201);
  CHECK(wait_for(app, "PrintStarted")["event"]["payload"]["path"] == "a.gcode");
  CHECK(wait_for(app, "PrintDone")["event"]["payload"]["name"] == "a.gcode");
  const json state = wait_for(app, "current")["current"];
  CHECK(state["state"]["flags"]["ready"] == true);
  CHECK(state["temps"].size() == 1);
}

TEST_CASE("A print that is cancelled by an app is told as cancelled") {
  const test::RunningDaemon daemon;
  WebSocketClient app(daemon.port(), kRaw);
  REQUIRE(daemon.put("/api/v1/files/part.lua", test::example("gyroid_sphere.lua")).status == 201);
  REQUIRE(daemon.post("/api/v1/jobs", R"({"file": "part.lua"})").status == 201);
  CHECK(!wait_for(app, "PrintStarted").is_null());

  CHECK(daemon.post("/api/job", R"({"command": "cancel"})").status == 204);

  CHECK(!wait_for(app, "PrintCancelled").is_null());
  CHECK(wait_for(app, "PrintFailed")["event"]["payload"]["reason"] == "cancelled");
}

TEST_CASE("SockJS asks first, then talks in its own frames") {
  const test::RunningDaemon daemon;
  const json info = test::json_of(daemon.get("/sockjs/info?t=1764230000000"));
  CHECK(info["websocket"] == true);
  CHECK(info["cookie_needed"] == false);
  CHECK(info["entropy"].is_number_unsigned());

  WebSocketClient app(daemon.port(), kSockJs);

  CHECK(app.text() == "o");
  const auto frame = app.text();
  REQUIRE(frame);
  CHECK(frame->starts_with("a["));
  CHECK(kind_of(json::parse(frame->substr(1))[0].get<std::string>()) == "connected");
}

TEST_CASE("Where a key is needed nothing flows before a valid session is shown") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey);
  WebSocketClient stranger(daemon.port(), kRaw);
  WebSocketClient owner(daemon.port(), kRaw, key_of(daemon));
  CHECK(next_kind(stranger) == "connected");
  CHECK(next_kind(owner) == "connected");
  CHECK(next_kind(owner) == "history");
  stranger.say(R"({"auth": "slipstick:none"})");
  stranger.say(R"({"auth": "slipstick:"})");
  REQUIRE(test::request(daemon.port(), "PUT", "/api/v1/files/secret.lua", "return box(1, 1, 1)",
                        key_of(daemon))
              .status == 201);
  CHECK(!wait_for(owner, "FileAdded").is_null());
  REQUIRE(test::request(daemon.port(), "POST", "/api/files/local/secret.lua",
                        R"({"command": "select"})", key_of(daemon))
              .status == 204);

  stranger.say(auth_of(daemon));

  // The first that it hears is how things are now, and no event of before.
  const auto first = stranger.text();
  REQUIRE(first);
  CHECK(json::parse(*first)["history"]["job"]["file"]["name"] == "secret.lua");
  CHECK(test::request(daemon.port(), "POST", "/api/login", R"({"passive": true})").status == 403);
}

TEST_CASE("A socket ends with the key that opened it") {
  HttpLimits limits;
  limits.admission_lasts = 50ms;
  test::GuardedDaemon daemon(limits);
  WebSocketClient app(daemon.port(), kRaw, test::by_key(daemon.new_key(Scope::kRead)));
  CHECK(next_kind(app) == "connected");
  const auto before = std::chrono::steady_clock::now();

  REQUIRE(*daemon.accounts().remove_key(1));

  while (app.text()) {
  }
  CHECK(std::chrono::steady_clock::now() - before < 30s);  // the client itself gives up after 60
}

TEST_CASE("Who shows no session in time is sent away") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey, limits_with(200ms, 60s, 64));

  WebSocketClient raw(daemon.port(), kRaw);
  WebSocketClient sock_js(daemon.port(), kSockJs);

  CHECK(raw.close_code() == kPolicy);
  CHECK(sock_js.text() == "o");
  CHECK(sock_js.text()->starts_with("a["));
  CHECK(sock_js.text() == "c[3000,\"Go away!\"]");
}

TEST_CASE("Pages of other sites and other names open no socket") {
  const test::RunningDaemon daemon;

  CHECK(WebSocketClient(daemon.port(), kRaw, "Origin: http://evil.example\r\n").refusal().status ==
        403);
  CHECK(WebSocketClient(daemon.port(), kSockJs, "Origin: null\r\n").refusal().status == 403);
  CHECK(WebSocketClient(daemon.port(), kRaw, "Origin: http://localhost\r\n").is_open());
  CHECK(test::request(daemon.port(), "GET", "/sockjs/info", "", "Origin: http://evil.example\r\n")
            .status == 403);
}

TEST_CASE("What is no WebSocket is told so") {
  const test::RunningDaemon daemon;
  const auto ask = [&](std::string_view head) {
    return test::request(daemon.port(), "GET", kRaw, "", head).status;
  };
  const std::string upgrade = "Connection: keep-alive, Upgrade\r\nUpgrade: websocket\r\n";
  const std::string key = "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";

  CHECK(daemon.get(kRaw).status == 426);
  CHECK(daemon.get(kRaw).headers.at("upgrade") == "websocket");
  CHECK(daemon.post(kRaw).status == 405);
  CHECK(ask("Upgrade: websocket\r\n") == 426);
  CHECK(ask(upgrade + key) == 426);
  CHECK(ask(upgrade + key + "Sec-WebSocket-Version: 8\r\n") == 426);
  CHECK(ask(upgrade + "Sec-WebSocket-Version: 13\r\n") == 400);
  CHECK(ask(upgrade + "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: short\r\n") == 400);
  CHECK(ask(upgrade + key + "Sec-WebSocket-Version: 13\r\nContent-Length: 4\r\n") == 400);
}

TEST_CASE("Frames that no client may send end the socket, and nothing else") {
  const test::RunningDaemon daemon;
  const std::string end(40'000, 'x');
  const std::string text = frame_bytes(0x81, "{}");
  for (const std::string& bytes : {
           std::string("\x81\x02{}", 4),              // not masked
           frame_bytes(0xc1, "{}"),                   // a reserved bit
           frame_bytes(0x83, "{}"),                   // no such kind
           frame_bytes(0x80, "{}"),                   // goes on with nothing
           frame_bytes(0x01, "{}") + text,            // begins within another
           frame_bytes(0x09, "ping") + text,          // a ping in parts
           frame_bytes(0x89, std::string(126, 'p')),  // a ping that is too long
           frame_bytes(0x88, "\x03"),                 // half a code
           frame_bytes(0x88, "\x03\xed"),             // 1005, which is never sent
           frame_bytes(0x81, "\"\xff\xfe\""),         // not UTF-8
           std::string("\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0", 14),  // 2^63 bytes
           std::string("\x81\xff\xff\xff\xff\xff\xff\xff\xff\xff\0\0\0\0", 14),  // 2^64 bytes
           std::string("\x81\xfe\x00\x02\0\0\0\0{}", 10),  // a length written too long
       }) {
    INFO(Catch::StringMaker<std::string>::convert(bytes));
    WebSocketClient client(daemon.port(), kRaw);
    REQUIRE(client.is_open());

    client.send(bytes + end);

    while (client.frame()) {
    }
  }
  CHECK(daemon.get("/api/v1/jobs").status == 200);
}

TEST_CASE("A message of more than 16 KiB is refused, in one piece or in many") {
  const test::RunningDaemon daemon;
  WebSocketClient whole(daemon.port(), kRaw), parts(daemon.port(), kRaw);

  whole.say(std::string((16 << 10) + 1, ' '));
  parts.send(frame_bytes(0x01, std::string(10'000, ' ')));
  parts.send(frame_bytes(0x80, std::string(10'000, ' ')));

  CHECK(whole.close_code() == kTooBig);
  CHECK(parts.close_code() == kTooBig);
}

TEST_CASE("A message in parts with a ping between is understood") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey);
  WebSocketClient app(daemon.port(), kRaw);
  const std::string auth = auth_of(daemon);
  CHECK(next_kind(app) == "connected");

  app.send(frame_bytes(0x01, auth.substr(0, 5)) + frame_bytes(0x89, "still there?") +
           frame_bytes(0x00, auth.substr(5, 9)) + frame_bytes(0x80, auth.substr(14)));

  const auto pong = app.frame();
  REQUIRE(pong);
  CHECK(pong->opcode() == test::kPongFrame);
  CHECK(pong->payload == "still there?");
  CHECK(next_kind(app) == "history");
}

TEST_CASE("Who says too much is sent away") {
  const test::RunningDaemon daemon;
  WebSocketClient talker(daemon.port(), kRaw), pinger(daemon.port(), kRaw);

  // Seconds may begin anew in between, once or twice.
  for (int i = 0; i < 4 * PushClient::kMessagesMax; ++i) talker.say("{}");
  for (int i = 0; i < 4 * PushClient::kMessagesMax; ++i) pinger.send(frame_bytes(0x89, ""));

  CHECK(talker.close_code() == kPolicy);
  while (pinger.frame()) {
  }
}

TEST_CASE("Listeners of both kinds are counted together") {
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", limits_with(15s, 60s, 2));
  test::EventReader stream(daemon);
  WebSocketClient app(daemon.port(), kRaw);
  REQUIRE(app.is_open());

  CHECK(WebSocketClient(daemon.port(), kRaw).refusal().status == 503);
  CHECK(daemon.get("/api/v1/events").status == 503);
}

TEST_CASE("Where too many listen, a valid session comes to nothing") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey, limits_with(15s, 60s, 1));
  WebSocketClient first(daemon.port(), kRaw, key_of(daemon));
  REQUIRE(first.is_open());
  WebSocketClient second(daemon.port(), kRaw);
  REQUIRE(second.is_open());

  second.say(auth_of(daemon));

  CHECK(second.close_code() == kTryLater);
  CHECK(next_kind(first) == "connected");
}

TEST_CASE("Sockets that show no session keep nobody out") {
  HttpLimits limits;
  limits.connections = 3;
  const test::RunningDaemon daemon("sim:", test::kNeedsKey, limits);
  std::vector<WebSocketClient> strangers;
  for (int i = 0; i < 3; ++i) strangers.emplace_back(daemon.port(), kRaw);
  for (auto& stranger : strangers) CHECK(next_kind(stranger) == "connected");

  CHECK(test::request(daemon.port(), "GET", "/api/v1/jobs", "", key_of(daemon)).status == 200);
  CHECK(!strangers[0].frame());  // who waited longest gave way
}

TEST_CASE("A silent client is pinged; one that does not answer is cut off") {
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", limits_with(15s, 400ms, 64));
  WebSocketClient lively(daemon.port(), kRaw), dead(daemon.port(), kRaw);

  for (int pings = 0; pings < 3;) {
    const auto frame = lively.frame();
    REQUIRE(frame);
    if (frame->opcode() != test::kPingFrame) continue;
    ++pings;
    lively.send(frame_bytes(test::kFinalFrame | test::kPongFrame, frame->payload));
  }

  while (dead.frame()) {
  }
  REQUIRE(daemon.put("/api/v1/files/a.lua", "return box(1, 1, 1)").status == 201);
  CHECK(!wait_for(lively, "FileAdded").is_null());
}

TEST_CASE("A client that says goodbye is answered") {
  const test::RunningDaemon daemon;
  WebSocketClient app(daemon.port(), kRaw);

  app.send(frame_bytes(0x88, std::string("\x03\xe8", 2) + "done"));

  CHECK(app.close_code() == 1000);
  CHECK(!app.frame());
}

TEST_CASE("A client that takes nothing is cut off") {
  // History with more than all buffers between here and there hold.
  EventLog log{[] {}};
  HttpSite site;
  site.admit = [](const HttpRequest& head) { return find_route(head.method, head.target); };
  site.answer = [](const Route&, const HttpRequest&) { return HttpResponse{}; };
  site.push.moment = [] { return OctoMoment{}; };
  site.push.admits = [](const HttpRequest&) { return true; };
  HttpLimits limits;
  limits.write_patience = 300ms;
  limits.streams = 1;
  auto server = HttpServer::listen("127.0.0.1:0", std::move(site), limits);
  REQUIRE(server);
  const std::string address = (*server)->address();
  const auto port = static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
  std::jthread thread([&](const std::stop_token& stop) {
    (*server)->run(log, [&] { return !stop.stop_requested(); });
  });
  // The server takes events in from the moment at which it runs, as the first answer shows.
  REQUIRE(test::request(port, "GET", "/api/version").status == 200);
  const json line{{"text", std::string(400'000, 'x')}};
  for (int i = 0; i < 64; ++i) log.publish("log", line.dump());

  WebSocketClient lazy(port, kRaw);
  REQUIRE(lazy.is_open());

  // Its place is free again once it is cut off.
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  bool free = false;
  while (!free && std::chrono::steady_clock::now() < deadline) {
    free = WebSocketClient(port, kRaw).is_open();
  }
  CHECK(free);
}
