// Programs that ask for a key: OctoPrint's application keys.
#include <catch2/catch.hpp>

#include "host/serve/app_requests.h"
#include "tests/host/guarded_daemon.h"

using namespace slipstick;
using namespace std::chrono_literals;
using nlohmann::json;

namespace {

constexpr const char* kAsk = "/plugin/appkeys/request";

// A guarded daemon and Ada's browser, in which she decides.
struct Desk {
  test::HttpReply ask(const std::string& app) const {
    return daemon.ask("POST", kAsk, "", json{{"app", app}}.dump());
  }
  test::HttpReply answer(const std::string& token) const {
    return daemon.ask("GET", std::string(kAsk) + "/" + token);
  }
  json requests() {
    return test::json_of(daemon.ask("GET", "/api/v1/app-requests", ada))["requests"];
  }
  int decide(const std::string& password) const {
    const json body{{"scope", "print"}, {"password", password}};
    return daemon.ask("POST", "/api/v1/app-requests/1", ada, body.dump()).status;
  }
  int jobs_as(const std::string& key) const {
    return daemon.ask("GET", "/api/job", "X-Api-Key: " + key + "\r\n").status;
  }

  test::GuardedDaemon daemon;
  std::string ada = test::from_page(daemon.new_session());
};

AppRequests::Moment at(std::chrono::seconds seconds) {
  return AppRequests::Moment() + seconds;
}

}  // namespace

TEST_CASE("A program that asks gets a key once somebody who is logged in gives it one") {
  Desk desk;
  REQUIRE(desk.daemon.ask("GET", "/plugin/appkeys/probe").status == 204);

  const auto asked = desk.ask("Cura");
  REQUIRE(asked.status == 201);
  const std::string token = test::json_of(asked)["app_token"];
  CHECK(asked.headers.at("location") == "http://localhost" + std::string(kAsk) + "/" + token);
  CHECK(desk.answer(token).status == 202);
  REQUIRE(desk.requests().size() == 1);
  CHECK(desk.requests()[0]["app"] == "Cura");
  REQUIRE(desk.decide(test::kPassword) == 204);

  const auto answered = desk.answer(token);
  REQUIRE(answered.status == 200);
  CHECK(desk.jobs_as(test::json_of(answered)["api_key"]) == 200);
  CHECK(desk.answer(token).status == 404);  // it is told once
  CHECK(desk.requests().empty());
}

TEST_CASE("A program that is refused gets nothing, and neither does who guesses") {
  Desk desk;
  const std::string token = test::json_of(desk.ask("Cura"))["app_token"];

  CHECK(desk.daemon.ask("DELETE", "/api/v1/app-requests/1", desk.ada).status == 204);

  CHECK(desk.answer(token).status == 404);
  CHECK(desk.answer(std::string(64, '0')).status == 404);
  CHECK(desk.daemon.ask("DELETE", "/api/v1/app-requests/1", desk.ada).status == 404);
}

TEST_CASE("Only who is logged in decides, by the password") {
  Desk desk;
  const std::string token = test::json_of(desk.ask("Cura"))["app_token"];
  const std::string body = json{{"scope", "admin"}, {"password", test::kPassword}}.dump();
  const std::string key = "X-Api-Key: " + desk.daemon.new_key(Scope::kAdmin) + "\r\n";

  CHECK(desk.daemon.ask("POST", "/api/v1/app-requests/1", "", body).status == 401);
  CHECK(desk.daemon.ask("POST", "/api/v1/app-requests/1", key, body).status == 403);
  CHECK(desk.daemon.ask("GET", "/api/v1/app-requests").status == 401);
  CHECK(desk.decide("wrong horse battery") == 403);

  CHECK(desk.answer(token).status == 202);
}

TEST_CASE("What is asked badly, by too many, or where no key is needed, is refused") {
  Desk desk;
  for (const char* body :
       {"", "[]", "{}", R"({"app": 1})", R"({"app": ""})", R"({"app": "a\nb"})"}) {
    INFO(body);
    CHECK(desk.daemon.ask("POST", kAsk, "", body).status == 400);
  }
  for (std::size_t i = 0; i < AppRequests::kWaitingMost; ++i) {
    CHECK(desk.ask("Cura").status == 201);
  }
  CHECK(desk.ask("Cura").status == 429);

  const test::RunningDaemon open;
  CHECK(open.get("/plugin/appkeys/probe").status == 404);
  CHECK(open.post(kAsk, R"({"app": "Cura"})").status == 404);
}

TEST_CASE("Who stops asking for its answer, or waits too long, is forgotten") {
  AppRequests apps;
  const auto cura = AccountName::from("Cura");
  const auto silent = apps.ask(*cura, "192.0.2.1", at(0s));
  const auto faithful = apps.ask(*cura, "192.0.2.2", at(0s));
  REQUIRE((silent && faithful));

  for (auto time = 10s; time <= AppRequests::kAgeMost; time += 10s) {
    CHECK(apps.answer(*faithful, at(time)) == "");
  }

  CHECK_FALSE(apps.answer(*silent, at(AppRequests::kAgeMost)));
  REQUIRE(apps.waiting(at(AppRequests::kAgeMost)).size() == 1);
  CHECK(apps.waiting(at(AppRequests::kAgeMost))[0].from == "192.0.2.2");
  CHECK_FALSE(apps.answer(*faithful, at(AppRequests::kAgeMost + 1s)));
}
