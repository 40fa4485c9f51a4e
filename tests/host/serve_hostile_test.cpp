// Clients that keep the daemon waiting, send too much, or send what is no request: they are
// answered or cut off, keep nobody out, and leave nothing behind.
#include <catch2/catch.hpp>
#include <deque>

#include "host/serve/http_seats.h"
#include "tests/host/serve_fixture.h"

using namespace slipstick;
using namespace std::chrono_literals;
using Catch::Contains;

namespace {

constexpr auto kSoon = 300ms;
constexpr std::string_view kHost = " HTTP/1.1\r\nHost: localhost\r\n";

HttpLimits impatient() {
  HttpLimits limits;
  limits.head_patience = kSoon;
  limits.body_patience = kSoon;
  return limits;
}

HttpLimits few_connections() {
  HttpLimits limits;
  limits.connections = 4;
  limits.streams = 2;
  return limits;
}

std::string head(std::string_view request) {
  return std::string(request) + std::string(kHost);
}

// One byte after the other, much faster than the patience of the daemon; whether it is cut off.
bool cut_off_while_trickling(test::HttpClient& client, std::string_view byte) {
  for (int i = 0; i < 1000; ++i) {
    client.send(byte);
    if (client.ended_within(10ms)) return true;
  }
  return false;
}

// The status of what is sent in one piece on a connection of its own.
int status_of(const test::RunningDaemon& daemon, std::string_view bytes) {
  test::HttpClient client(daemon.port());
  client.send(bytes);
  return client.reply().status;
}

std::uintmax_t incoming_bytes(const test::RunningDaemon& daemon) {
  std::uintmax_t sum = 0;
  for (const auto& file : std::filesystem::directory_iterator(daemon.data() / "incoming")) {
    sum += file.file_size();
  }
  return sum;
}

bool nothing_incoming(const test::RunningDaemon& daemon) {
  return std::filesystem::is_empty(daemon.data() / "incoming");
}

}  // namespace

TEST_CASE("Who sends a head a byte at a time is cut off, however steadily the bytes come") {
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", impatient());
  test::HttpClient client(daemon.port());
  client.send("GET /api/v1/printer HTTP/1.1\r\nX-Long: ");

  CHECK(cut_off_while_trickling(client, "a"));
  CHECK(daemon.get("/api/v1/printer").status == 200);
}

TEST_CASE("Who sends a body a byte at a time is cut off, in text, uploads and chunks") {
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", impatient());
  const std::string sized = "Content-Length: 100000\r\n\r\n";
  for (const auto& [request, byte] :
       {std::pair(head("POST /api/v1/jobs") + sized, "a"),
        std::pair(head("PUT /api/v1/files/a.lua") + sized, "a"),
        std::pair(head("PUT /api/v1/files/a.lua") + "Transfer-Encoding: chunked\r\n\r\n",
                  "1\r\na\r\n")}) {
    INFO(request);
    test::HttpClient client(daemon.port());
    client.send(request);

    CHECK(cut_off_while_trickling(client, byte));
  }
  // Asked first: the server has had another turn then.
  CHECK(test::json_of(daemon.get("/api/v1/files"))["files"].empty());
  CHECK(nothing_incoming(daemon));
}

TEST_CASE("Who stops in the middle of a body is cut off, and what came of it is removed") {
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", impatient());
  test::HttpClient client(daemon.port());

  client.send(head("PUT /api/v1/files/a.lua") + "Content-Length: 60\r\n\r\nhalf");

  CHECK(client.ended_within(60s));
  CHECK(daemon.get("/api/v1/printer").status == 200);  // the server has had another turn
  CHECK(nothing_incoming(daemon));
}

TEST_CASE("Clients that say nothing keep nobody out: the longest silent gives way") {
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", few_connections());
  std::deque<test::HttpClient> silent;
  for (int i = 0; i < 4; ++i) silent.emplace_back(daemon.port()).send("GET /");

  std::deque<test::HttpClient> others;
  for (int i = 0; i < 4; ++i) {
    others.emplace_back(daemon.port()).send(head("GET /api/v1/printer") + "\r\n");
    CHECK(others.back().reply().status == 200);
    CHECK(silent[static_cast<std::size_t>(i)].ended_within(60s));
  }
}

TEST_CASE("Clients that stop in a body keep nobody out; an upload that goes on is let go on") {
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", few_connections());
  const std::string stuck =
      head("POST /api/v1/jobs") + "Expect: 100-continue\r\nContent-Length: 10\r\n\r\n";
  const std::string half(100'000, ' ');
  test::HttpClient upload(daemon.port());
  upload.send(head("PUT /api/v1/files/a.lua") +
              "Expect: 100-continue\r\nContent-Length: 200000\r\n\r\n");
  REQUIRE(upload.reply().status == 100);
  std::deque<test::HttpClient> silent;
  for (int i = 0; i < 3; ++i) {
    silent.emplace_back(daemon.port()).send(stuck);
    REQUIRE(silent.back().reply().status == 100);
  }

  upload.send(half);
  for (int i = 0; i < 10'000 && incoming_bytes(daemon) == 0; ++i) {
    REQUIRE(!upload.ended_within(1ms));
  }
  CHECK(daemon.get("/api/v1/printer").status == 200);
  CHECK(silent[0].ended_within(60s));
  upload.send(half);

  CHECK(upload.reply().status == 201);
  CHECK(!silent[1].ended_within(0s));
}

TEST_CASE("Listeners to events are limited, so that requests always find a connection") {
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", few_connections());
  const test::EventReader first(daemon), second(daemon);

  CHECK(daemon.get("/api/v1/events").status == 503);
  CHECK(daemon.get("/api/v1/printer").status == 200);
}

TEST_CASE(
    "A seat goes to a newcomer by who waits longest for nothing, and never by who is served") {
  HttpSeats seats(3, 3);
  using enum HttpSeats::Doing;
  const auto a = seats.take(""), b = seats.take(""), c = seats.take("");
  REQUIRE((a && b && c && !a->freed));
  seats.does(a->seat, kTransfer);
  seats.does(b->seat, kService);
  seats.does(c->seat, kSpeech);

  const auto d = seats.take("");
  CHECK(d->freed == c->seat);  // is to say something, although `a` waits longer
  seats.does(d->seat, kService);
  const auto e = seats.take("");
  CHECK(e->freed == a->seat);
  seats.does(e->seat, kService);
  CHECK(!seats.take(""));
  seats.leave(b->seat);
  CHECK(seats.take(""));
}

TEST_CASE("Layers that are asked for beyond those that wait already are refused") {
  HttpLimits limits;
  limits.slow_requests = 0;
  const test::RunningDaemon daemon("sim:", "127.0.0.1:0", limits);

  CHECK(daemon.get("/api/v1/files/a.lua/layers/1").status == 503);
  CHECK(daemon.get("/api/v1/printer").status == 200);
}

TEST_CASE("Another machine gets its share of the connections; beyond it, only its own give way") {
  HttpSeats seats(10, 2);
  const auto ours = seats.take("");
  const auto other = seats.take("192.0.2.9");
  const auto a = seats.take("192.0.2.7"), b = seats.take("192.0.2.7");

  const auto c = seats.take("192.0.2.7");
  CHECK(c->freed == a->seat);
  seats.does(b->seat, HttpSeats::Doing::kService);
  seats.does(c->seat, HttpSeats::Doing::kService);
  CHECK(!seats.take("192.0.2.7"));
  for (int i = 0; i < 6; ++i) CHECK(!seats.take("")->freed);
  CHECK(seats.take("")->freed == ours->seat);
  CHECK(seats.taken() == 10);
  CHECK(other);
}

TEST_CASE("Addresses of one customer count as one machine") {
  CHECK(http_peer("127.0.0.1").empty());
  CHECK(http_peer("::1").empty());
  CHECK(http_peer("::ffff:127.0.0.1").empty());
  CHECK(http_peer("::ffff:192.0.2.7") == http_peer("192.0.2.7"));
  CHECK(http_peer("192.0.2.7") != http_peer("192.0.2.8"));
  CHECK(http_peer("2001:db8:0:1::1") == http_peer("2001:db8:0:1:ffff::2"));
  CHECK(http_peer("2001:db8:0:1::1") != http_peer("2001:db8:0:2::1"));
}

TEST_CASE("JSON that is too deep or has too many members is refused, quickly") {
  const test::RunningDaemon daemon;
  std::string members = "{";
  for (int i = 0; i < 90'000; ++i) members += "\"" + std::to_string(i) + "\":1,";
  members += "\"file\":\"a\"}";
  REQUIRE(members.size() < (1 << 20));

  for (const std::string& body :
       {std::string(500'000, '['), std::string(500'000, '[') + std::string(500'000, ']'),
        "{\"spec\":" + std::string(500'000, '[') + std::string(500'000, ']') + "}", members}) {
    INFO(body.substr(0, 60));
    CHECK(daemon.post("/api/v1/jobs", body).status == 400);
    CHECK(daemon.post("/api/printer/command", body).status == 400);
  }
}

TEST_CASE("JSON of the wrong types is refused, by every route that takes some") {
  const test::RunningDaemon daemon;

  for (const char* body :
       {R"({"file": {"file": []}})", "{\"file\": \"\xff\"}", R"({"file": 1e999})",
        R"({"spec": {"settings": {"perimeters": [3]}}})", R"({"spec": [[]], "command": [{}]})",
        R"({"spec": {"placement": {"fit": [1, "2", null]}}, "command": null})",
        R"({"spec": {"printer": "../../etc/passwd"}, "command": {"command": "connect"}})",
        R"({"spec": {"material": "/etc/passwd"}})", R"([1, 2])", "7", R"("jobs")", "null"}) {
    INFO(body);
    for (const char* target : {"/api/v1/jobs", "/api/v1/printer/adjust", "/api/v1/printer/commands",
                               "/api/connection", "/api/printer/printhead", "/api/printer/tool",
                               "/api/printer/bed", "/api/printer/command", "/api/job"}) {
      INFO(target);
      CHECK(daemon.post(target, body).status == 400);
    }
  }
}

TEST_CASE("A text that says it is too long is refused before it is sent") {
  const test::RunningDaemon daemon;
  test::HttpClient client(daemon.port());

  client.send(head("POST /api/v1/jobs") +
              "Expect: 100-continue\r\nContent-Length: 1048577\r\n\r\n");

  CHECK(client.reply().status == 413);
  CHECK(client.ended());
}

TEST_CASE("No route that takes a name takes one that leads elsewhere") {
  const test::RunningDaemon daemon;
  std::ofstream(daemon.data() / "secret.lua") << "secret";

  for (const char* name : {"..%2fsecret.lua", "..%5csecret.lua", "%2e%2e%2fsecret.lua",
                           "%2fetc%2fpasswd", "a.lua%2f..%2f..%2fsecret.lua", "secret.lua%00"}) {
    const std::string path(name);
    INFO(path);
    CHECK(daemon.get("/api/v1/files/" + path).status == 404);
    CHECK(daemon.put("/api/v1/files/" + path, "return").status == 400);
    CHECK(daemon.remove("/api/v1/files/" + path).status == 404);
    CHECK(daemon.get("/api/v1/files/" + path + "/layers").status == 404);
    CHECK(daemon.get("/api/v1/files/" + path + "/layers/0").status == 404);
    CHECK(daemon.get("/api/files/local/" + path).status == 404);
    CHECK(daemon.post("/api/files/local/" + path, R"({"command": "select"})").status == 404);
    CHECK(daemon.remove("/api/files/local/" + path).status == 404);
    CHECK(daemon.get("/assets/" + path).status == 404);
    CHECK(daemon.get("/api/v1/jobs/" + path).status == 404);
    CHECK(daemon.post("/api/v1/jobs/" + path + "/cancel").status == 404);
    CHECK(daemon.post("/api/v1/jobs/" + path + "/take-up").status == 404);
    CHECK(daemon.post("/api/v1/jobs", nlohmann::json{{"file", path}}.dump()).status == 404);
  }
  CHECK(daemon.post("/api/v1/jobs", R"({"file": "../secret.lua"})").status == 404);
  CHECK(std::filesystem::exists(daemon.data() / "secret.lua"));
}

TEST_CASE("A body that is not what its head says is refused") {
  const test::RunningDaemon daemon;
  const std::string jobs = head("POST /api/v1/jobs");
  const std::string chunked = jobs + "Transfer-Encoding: chunked\r\n";

  for (const std::string& bytes :
       {jobs + "Content-Length: -1\r\n\r\n", jobs + "Content-Length: 1x\r\n\r\n",
        jobs + "Content-Length: 99999999999999999999\r\n\r\n",
        jobs + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}x",
        chunked + "Content-Length: 2\r\n\r\n{}", chunked + "\r\nzz\r\n", chunked + "\r\n-1\r\n{}",
        chunked + "\r\nffffffffffffffffff\r\n{}", chunked + "\r\n2\r\n{}xx0\r\n\r\n"}) {
    INFO(bytes);
    CHECK(status_of(daemon, bytes) == 400);
  }
  test::HttpClient half(daemon.port());
  half.send(jobs + "Content-Length: 10\r\n\r\n{}");
  half.end_sending();
  CHECK(half.reply().status == 400);
  CHECK(status_of(daemon, jobs + "Transfer-Encoding: gzip\r\n\r\n") == 400);
  CHECK(status_of(daemon, chunked + "\r\n2;a=b\r\n{}\r\n0\r\nX: y\r\n\r\n") == 404);  // no file
  CHECK(nothing_incoming(daemon));
}

TEST_CASE("Chunks are bounded as whole bodies are") {
  const test::RunningDaemon daemon;
  test::HttpClient client(daemon.port());

  client.send(head("POST /api/v1/jobs") + "Transfer-Encoding: chunked\r\n\r\n");
  const std::string chunk = "10000\r\n" + std::string(0x10000, ' ') + "\r\n";
  for (int i = 0; i < 18; ++i) client.send(chunk);

  CHECK(client.reply().status == 413);
}

TEST_CASE("HEAD tells what GET would, without the body; other methods are refused") {
  const test::RunningDaemon daemon;
  test::HttpClient client(daemon.port());

  client.send(head("HEAD /api/v1/printer") + "\r\n" + head("HEAD /api/v1/events") + "\r\n" +
              head("GET /api/v1/jobs") + "\r\n");
  const std::string first = client.read_until("\r\n\r\n");
  CHECK_THAT(first, Contains(" 200 ") && Contains("Content-Length: "));
  CHECK_THAT(client.read_until("\r\n\r\n"), Contains("HTTP/1.1 200 "));
  CHECK(test::json_of(client.reply())["jobs"].empty());

  for (const char* method : {"OPTIONS", "TRACE", "PATCH", "PROPFIND", "BREW"}) {
    INFO(method);
    const auto refused = test::request(daemon.port(), method, "/api/v1/jobs");
    CHECK(refused.status == 405);
    CHECK(refused.headers.at("allow") == "GET, POST");
  }
  CHECK(test::request(daemon.port(), "CONNECT", "localhost:80").status == 400);
}

TEST_CASE("Many requests in one piece are answered in their order, and not beyond one refused") {
  const test::RunningDaemon daemon;
  test::HttpClient client(daemon.port());
  std::string many;
  for (int i = 0; i < 300; ++i) many += head("GET /api/v1/jobs") + "\r\n";

  client.send(many + head("POST /api/v1/jobs") + "Content-Length: x\r\n\r\n" +
              head("GET /api/v1/jobs") + "\r\n");

  for (int i = 0; i < 300; ++i) REQUIRE(client.reply().status == 200);
  CHECK(client.reply().status == 400);
  CHECK(client.ended());
}
