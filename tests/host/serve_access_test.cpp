// Who may ask for what: every route, by everybody.
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "host/serve/access.h"
#include "tests/host/guarded_daemon.h"

using namespace slipstick;
using Catch::Contains;

namespace {

// The rules, with accounts of their own.
struct Door {
  test::TemporaryFolder folder;
  Accounts accounts = test::accounts_in(folder.path());
  AccessRules rules;

  Door(Reach reach, const std::string& key) : rules(reach, key) {}

  unsigned answer(const std::map<std::string, std::string>& headers,
                  HttpMethod method = HttpMethod::kGet) {
    HttpRequest request;
    request.method = method;
    request.headers = headers;
    request.target = *parse_http_target("/api/v1/jobs");
    const auto verdict = rules.check(RouteAccess::kRead, request, accounts, 100);
    return verdict.refusal ? verdict.refusal->status : 200;
  }
};

std::string name_of(HttpMethod method) {
  constexpr std::array<const char*, 4> kNames{"GET", "POST", "PUT", "DELETE"};
  return kNames.at(static_cast<std::size_t>(method));
}

// "/api/v1/jobs/{id}" with something in place of the names.
std::string target_of(const Route& route) {
  std::string target(route.pattern);
  for (std::size_t at = target.find('{'); at != target.npos; at = target.find('{')) {
    target.replace(at, target.find('}') - at + 1, "0");
  }
  return target;
}

// Of the answer's head alone: events never end.
int status_of(const test::GuardedDaemon& daemon, const Route& route, const std::string& head) {
  test::HttpClient client(daemon.port());
  client.send(name_of(route.method) + " " + target_of(route) +
              " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n" + head + "\r\n");
  return std::stoi(client.read_until("\r\n\r\n").substr(9, 3));
}

bool refuses(int status) {
  return status == 401 || status == 403;
}

constexpr std::array kScopes{Scope::kRead, Scope::kPrint, Scope::kControl, Scope::kAdmin};

// The least that a key must be for, or nothing: then none will do.
std::optional<Scope> needed(const Route& route) {
  if (route.access == RouteAccess::kAccount) return {};
  return static_cast<Scope>(static_cast<int>(route.access) - 1);
}

// Runs `check` for each route that asks for anything.
template <typename Check>
void for_each_guarded(Check check) {
  int count = 0;
  for (const Route& route : routes()) {
    if (route.access == RouteAccess::kAnyone) continue;
    INFO(name_of(route.method) << " " << route.pattern);
    ++count;
    check(route);
  }
  CHECK(count > 40);
}

}  // namespace

TEST_CASE(
    "Without an account only this machine's own names are answered, and no other site's pages") {
  for (const char* key : {"", "0123456789abcdef"}) {
    Door door(Reach::kMachine, key);

    for (const char* host : {"localhost", "localhost:5000", "127.0.0.1:5000", "[::1]:5000"}) {
      INFO(host);
      CHECK(door.answer({{"host", host}}) == 200);
    }
    CHECK(door.answer({{"host", "localhost:5000"}, {"origin", "http://localhost:5000"}}) == 200);
    CHECK(door.answer({}) == 403);
    CHECK(door.answer({{"host", "evil.example:5000"}}) == 403);  // a name made to point here
    CHECK(door.answer({{"host", "127.0.0.1.evil.example"}}) == 403);
    CHECK(door.answer({{"host", "localhost:5000"}, {"origin", "http://evil.example"}}) == 403);
    CHECK(door.answer({{"host", "localhost:5000"}, {"origin", "null"}}) == 403);
  }
}

TEST_CASE("Off this machine nobody is answered who shows nothing, account or not") {
  Door door(Reach::kNetwork, "0123456789abcdef");
  const std::string host = "printer.lan:5000";

  for (int round = 0; round < 2; ++round) {
    CHECK(door.answer({{"host", host}, {"x-api-key", "0123456789abcdef"}}) == 200);
    CHECK(door.answer({{"host", host}, {"authorization", "Bearer 0123456789abcdef"}}) == 200);
    for (const char* wrong : {"", "0123456789abcdeF", "0123456789abcde", "0123456789abcdef0"}) {
      INFO(wrong);
      CHECK(door.answer({{"host", host}, {"x-api-key", wrong}}) == 401);
    }
    CHECK(door.answer({{"host", "localhost"}}) == 401);
    REQUIRE(door.accounts.add_first(*AccountName::from("ada"), "hash", 100));
  }
}

TEST_CASE("No empty key is the key of a folder that has none") {
  Door door(Reach::kMachine, "");
  REQUIRE(door.accounts.add_first(*AccountName::from("ada"), "hash", 100));

  CHECK(door.answer({{"host", "localhost"}, {"x-api-key", ""}}) == 401);
  CHECK(door.answer({{"host", "localhost"}, {"authorization", "Bearer "}}) == 401);
  CHECK(door.answer({{"host", "localhost"}, {"cookie", "slipstick="}}) == 401);
}

TEST_CASE("A browser's request that changes anything must come from the page, and say so") {
  Door door(Reach::kNetwork, "0123456789abcdef");
  const auto user = (**door.accounts.add_first(*AccountName::from("ada"), "hash", 100)).id;
  const std::string token = *door.accounts.begin_session(user, 100);
  const std::string host = "printer.lan:5000";
  const auto with = [&](std::map<std::string, std::string> more) {
    more.insert({{"host", host}, {"cookie", "a=b; slipstick5000=" + token + "; c=d"}});
    return more;
  };
  for (const auto method : {HttpMethod::kPost, HttpMethod::kPut, HttpMethod::kDelete}) {
    CHECK(door.answer(with({}), method) == 403);
    CHECK(door.answer(with({{"origin", "http://printer.lan:5000"}}), method) == 200);
    CHECK(door.answer(with({{"sec-fetch-site", "same-origin"}}), method) == 200);
    for (const char* origin : {"http://evil.example", "http://printer.lan:5001", "null",
                               "http://printer.lan", "http://printer.lan:5000.evil.example"}) {
      INFO(origin);
      CHECK(door.answer(with({{"origin", origin}}), method) == 403);
      CHECK(door.answer(with({{"origin", origin}, {"sec-fetch-site", "same-origin"}}), method) ==
            403);
    }
    for (const char* site : {"same-site", "cross-site", "none", ""}) {
      INFO(site);
      CHECK(door.answer(with({{"sec-fetch-site", site}}), method) == 403);
    }
    // No browser shows a key by itself.
    CHECK(door.answer({{"host", host}, {"x-api-key", "0123456789abcdef"}}, method) == 200);
  }
  CHECK(door.answer(with({})) == 200);
}

TEST_CASE("No route answers who shows nothing, and none is left out") {
  const test::GuardedDaemon daemon;

  for_each_guarded([&](const Route& route) {
    CHECK(refuses(status_of(daemon, route, "")));
    CHECK(refuses(status_of(daemon, route, test::by_key("0"))));
    CHECK(refuses(status_of(daemon, route, test::from_page("0"))));
  });
}

TEST_CASE("Every route refuses keys that are for less, and answers those that are for enough") {
  test::GuardedDaemon daemon;
  std::map<Scope, std::string> heads;
  for (const Scope scope : kScopes) heads[scope] = test::by_key(daemon.new_key(scope));

  for_each_guarded([&](const Route& route) {
    for (const Scope scope : kScopes) {
      INFO(name_of(scope));
      const bool is_enough = needed(route) && scope >= *needed(route);
      CHECK(refuses(status_of(daemon, route, heads[scope])) == !is_enough);
    }
  });
}

TEST_CASE("Every route answers who is logged in, but changes nothing for pages of others") {
  test::GuardedDaemon daemon;

  for_each_guarded([&](const Route& route) {
    const std::string session = daemon.new_session();
    const bool changes = route.method != HttpMethod::kGet;
    const auto status = [&](const std::string& more) {
      return status_of(daemon, route, "Cookie: slipstick=" + session + "\r\n" + more);
    };

    CHECK(status("Origin: http://evil.example\r\n") == 403);
    CHECK(refuses(status("")) == changes);
    CHECK(!refuses(status("Origin: http://localhost\r\n")));
  });
}

TEST_CASE("What anyone may ask for is the page and the way in, and nothing else") {
  std::set<std::string> open;
  for (const Route& route : routes()) {
    if (route.access == RouteAccess::kAnyone) {
      open.insert(name_of(route.method) + " " + std::string(route.pattern));
    }
  }

  CHECK(open ==
        std::set<std::string>{"GET /", "GET /assets/{name}", "GET /login", "GET /setup",
                              "GET /api/v1/session", "POST /api/v1/setup", "POST /api/v1/login",
                              "GET /plugin/appkeys/probe", "POST /plugin/appkeys/request",
                              "GET /plugin/appkeys/request/{token}", "GET /sockjs/info",
                              "GET /sockjs/websocket", "GET /sockjs/{server}/{session}/websocket"});
}
