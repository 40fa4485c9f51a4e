// The first run, logging in and out, keys: over sockets, as browsers and programs do it.
#include <catch2/catch.hpp>
#include <fstream>

#include "tests/host/guarded_daemon.h"

using namespace slipstick;
using namespace std::chrono_literals;
using Catch::Contains;
using nlohmann::json;

namespace {

std::string setup_body(const std::string& code, const std::string& name = "ada",
                       const std::string& password = "correct horse battery") {
  return json{{"code", code}, {"name", name}, {"password", password}}.dump();
}

std::string state_of(const test::RunningDaemon& daemon, const std::string& head = "") {
  const auto reply = test::request(daemon.port(), "GET", "/api/v1/session", "", head);
  return test::json_of(reply)["state"];
}

std::string key_body(const std::string& scope, const std::string& password = test::kPassword) {
  return json{{"name", "slicer"}, {"scope", scope}, {"password", password}}.dump();
}

}  // namespace

TEST_CASE(
    "Off this machine nothing but the page and the set-up answers before there is an account") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey);

  for (const char* target : {"/", "/login", "/setup", "/assets/setup.js", "/api/v1/session"}) {
    INFO(target);
    CHECK(daemon.get(target).status == 200);
  }
  CHECK(test::json_of(daemon.get("/api/v1/session")) ==
        json{{"state", "setup"}, {"code", true}, {"account", nullptr}, {"scope", nullptr}});
  const auto refused = daemon.get("/api/v1/printer");
  CHECK(refused.status == 401);
  CHECK_THAT(refused.body, Contains("no account yet"));
  CHECK(daemon.get("/nothing").status == 401);
  CHECK(daemon.post("/api/v1/login", R"({"name": "admin", "password": "admin"})").status == 403);
  const auto rights = std::filesystem::status(daemon.data() / "setup_code").permissions();
  CHECK((rights & std::filesystem::perms(0777)) == std::filesystem::perms(0600));
}

TEST_CASE("Who has the code makes the first account, once, and is logged in") {
  test::RunningDaemon daemon("sim:", test::kNeedsKey);
  std::string code;
  std::ifstream(daemon.data() / "setup_code") >> code;
  REQUIRE(code.size() == 14);

  CHECK(daemon.post("/api/v1/setup", setup_body("ABCD-EFGH-JKLM")).status == 403);
  CHECK(daemon.post("/api/v1/setup", setup_body("")).status == 403);
  CHECK(daemon.post("/api/v1/setup", setup_body(code, "")).status == 400);
  CHECK(daemon.post("/api/v1/setup", setup_body(code, "ada", "short")).status == 400);
  CHECK(daemon.post("/api/v1/setup", R"({"name": "ada", "password": "0123456789"})").status == 400);
  const auto made = daemon.post("/api/v1/setup", setup_body(code));

  CHECK(made.status == 200);
  const std::string page = test::from_page(test::session_in(made));
  CHECK(state_of(daemon, page) == "in");
  CHECK(state_of(daemon) == "login");
  CHECK(test::request(daemon.port(), "GET", "/api/v1/printer", "", page).status == 200);
  CHECK(daemon.post("/api/v1/setup", setup_body(code, "eve")).status == 409);
  CHECK(!std::filesystem::exists(daemon.data() / "setup_code"));
}

TEST_CASE("Guesses of the code are slowed down") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey);

  const auto guess = [&](int) {
    return daemon.post("/api/v1/setup", setup_body("ABCD-EFGH-JKLM"));
  };

  const auto reply = test::slowed_down(guess);

  CHECK(reply.status == 429);
  CHECK(std::stoi(reply.headers.at("retry-after")) >= 1);
}

TEST_CASE("On this machine nobody needs an account, until one is made") {
  const test::RunningDaemon daemon;
  CHECK(state_of(daemon) == "open");
  CHECK(daemon.get("/api/v1/printer").status == 200);
  CHECK(daemon.post("/api/v1/keys", key_body("read")).status == 409);

  const auto made = daemon.post("/api/v1/setup", R"({"name": "ada", "password": "0123456789"})");

  CHECK(made.status == 200);
  CHECK(daemon.get("/api/v1/printer").status == 401);
  CHECK(test::request(daemon.port(), "GET", "/api/v1/printer", "",
                      test::from_page(test::session_in(made)))
            .status == 200);
}

TEST_CASE("A forgotten password: the owner of the folder has the accounts forgotten") {
  const test::TemporaryFolder folder;
  REQUIRE(test::accounts_in(folder.path()).add_first(*AccountName::from("ada"), "hash", 100));
  std::ofstream(folder.path() / "forget_accounts") << "";
  Daemon::Options options;
  options.data = folder.path();
  options.listen = test::kNeedsKey;
  options.port = "sim:";

  const auto daemon = Daemon::start(options);

  REQUIRE(daemon);
  CHECK((*daemon)->setup_code().size() == 14);
  CHECK(*test::accounts_in(folder.path()).any() == false);
  CHECK(!std::filesystem::exists(folder.path() / "forget_accounts"));
}

TEST_CASE("The cookie of a session is no script's, no other site's, and not for ever") {
  const test::GuardedDaemon daemon;

  const auto reply = daemon.log_in(test::kAda, test::kPassword);

  CHECK(reply.status == 200);
  const std::string token = test::session_in(reply);
  CHECK(token.size() == 64);
  CHECK(reply.headers.at("set-cookie") ==
        "slipstick=" + token + "; Path=/; HttpOnly; SameSite=Strict; Max-Age=7776000");
}

TEST_CASE("Daemons at several ports of a host do not log each other out") {
  CHECK(session_cookie_name("printer.lan:5000") == "slipstick5000");
  CHECK(session_cookie_name("[::1]:5001") == "slipstick5001");
  CHECK(session_cookie_name("printer.lan") == "slipstick");
  CHECK(session_cookie_name("[::1]") == "slipstick");
  CHECK(session_cookie_name("a:1; x=") == "slipstick1");
}

TEST_CASE("Every login is another session, in place of the one that was shown") {
  test::GuardedDaemon daemon;
  const std::string before = daemon.new_session();

  const std::string after =
      test::session_in(daemon.log_in(test::kAda, test::kPassword, test::from_page(before)));

  CHECK(after != before);
  CHECK(state_of(daemon, test::from_page(after)) == "in");
  CHECK(state_of(daemon, test::from_page(before)) == "login");
}

TEST_CASE("Logging out ends this session, or all of them") {
  test::GuardedDaemon daemon;
  const std::string first = test::from_page(daemon.new_session());
  const std::string second = test::from_page(daemon.new_session());
  const std::string third = test::from_page(daemon.new_session());

  const auto left = daemon.ask("POST", "/api/v1/logout", first);
  CHECK(left.status == 204);
  CHECK_THAT(left.headers.at("set-cookie"), Contains("Max-Age=0"));
  CHECK(state_of(daemon, first) == "login");
  CHECK(state_of(daemon, second) == "in");

  CHECK(daemon.ask("POST", "/api/v1/logout-everywhere", second).status == 204);
  CHECK(state_of(daemon, second) == "login");
  CHECK(state_of(daemon, third) == "login");
}

TEST_CASE("Another password ends all other sessions, and is the one that counts") {
  test::GuardedDaemon daemon;
  const std::string mine = test::from_page(daemon.new_session());
  const std::string other = test::from_page(daemon.new_session());
  const auto change = [&](const std::string& old, const std::string& fresh) {
    return daemon.ask("POST", "/api/v1/password", mine, json{{"old", old}, {"new", fresh}}.dump());
  };

  CHECK(change("a wrong one", "0123456789").status == 403);
  CHECK(change(test::kPassword, "short").status == 400);
  CHECK(state_of(daemon, other) == "in");
  const auto changed = change(test::kPassword, "0123456789");

  CHECK(changed.status == 200);
  CHECK(state_of(daemon, test::from_page(test::session_in(changed))) == "in");
  CHECK(state_of(daemon, mine) == "login");
  CHECK(state_of(daemon, other) == "login");
  CHECK(daemon.log_in(test::kAda, test::kPassword).status == 403);
  CHECK(daemon.log_in(test::kAda, "0123456789").status == 200);
}

TEST_CASE("Who listens to events stops hearing them when the session ends") {
  HttpLimits limits;
  limits.admission_lasts = 50ms;
  test::GuardedDaemon daemon(limits);
  const std::string page = test::from_page(daemon.new_session());
  test::HttpClient listener(daemon.port());
  listener.send("GET /api/v1/events HTTP/1.1\r\nHost: localhost\r\n" + page + "\r\n");
  REQUIRE_THAT(listener.read_until("\r\n\r\n"), Contains(" 200 "));

  CHECK(daemon.ask("POST", "/api/v1/logout", page).status == 204);

  bool ended = false;
  for (int i = 0; i < 30 && !ended; ++i) ended = listener.ended_within(1s);
  CHECK(ended);
}

TEST_CASE("Mistakes are answered alike whether there is such an account, and slowed down alike") {
  const test::GuardedDaemon daemon;
  const auto wrong = daemon.log_in(test::kAda, "a wrong one");
  const auto nobody = daemon.log_in("eve", "a wrong one");
  CHECK(wrong.status == 403);
  CHECK(nobody.status == 403);
  CHECK(wrong.body == nobody.body);

  const auto soon = test::slowed_down([&](int) { return daemon.log_in("eve", "a wrong one"); });

  CHECK(soon.status == 429);
  CHECK(std::stoi(soon.headers.at("retry-after")) >= 1);
}

TEST_CASE("Passwords are looked at for a bounded number of clients at once") {
  HttpLimits limits;
  limits.secret_requests = 0;
  const test::GuardedDaemon daemon(limits);

  CHECK(daemon.log_in(test::kAda, test::kPassword).status == 503);
  CHECK(daemon.get("/api/v1/session").status == 200);
}

TEST_CASE("A body that does not say what is asked for is told so") {
  test::GuardedDaemon daemon;
  const std::string page = test::from_page(daemon.new_session());

  for (const char* target : {"/api/v1/login", "/api/v1/password", "/api/v1/keys"}) {
    for (const char* body : {"", "[]", "7", R"({"name": 7})", "{\"name\": \"\xff\"}",
                             R"({"name": "ada", "password": null})"}) {
      INFO(target << " " << body);
      CHECK(daemon.ask("POST", target, page, body).status == 400);
    }
  }
  const auto surplus =
      daemon.ask("POST", "/api/v1/login", "", R"({"name": "a", "password": "b", "admin": "yes"})");
  CHECK(surplus.status == 400);
  CHECK_THAT(surplus.body, Contains("admin"));
}

TEST_CASE("A key is made with the password, shown once, works everywhere, and can be removed") {
  test::GuardedDaemon daemon;
  const std::string page = test::from_page(daemon.new_session());

  CHECK(daemon.ask("POST", "/api/v1/keys", page, key_body("print", "a wrong one")).status == 403);
  CHECK(daemon.ask("POST", "/api/v1/keys", page, key_body("everything")).status == 400);
  const auto made = daemon.ask("POST", "/api/v1/keys", page, key_body("print"));

  CHECK(made.status == 201);
  const std::string key = test::json_of(made)["key"];
  const auto listed = daemon.ask("GET", "/api/v1/keys", page);
  CHECK(test::json_of(listed)["keys"][0]["name"] == "slicer");
  CHECK(test::json_of(listed)["keys"][0]["scope"] == "print");
  CHECK(listed.body.find(key) == std::string::npos);
  CHECK(daemon.ask("GET", "/api/v1/jobs", test::by_key(key)).status == 200);
  CHECK(daemon.ask("GET", "/api/v1/jobs", "Authorization: Bearer " + key + "\r\n").status == 200);
  CHECK(daemon.ask("PUT", "/api/v1/files/a.gcode", test::by_key(key), "G28\n").status == 201);
  CHECK(daemon.ask("DELETE", "/api/v1/keys/1", page).status == 204);
  CHECK(daemon.ask("DELETE", "/api/v1/keys/1", page).status == 404);
  CHECK(daemon.ask("DELETE", "/api/v1/keys/x", page).status == 404);
  CHECK(daemon.ask("GET", "/api/v1/jobs", test::by_key(key)).status == 401);
}

TEST_CASE(
    "A key in the address is taken only where OctoPrint's clients look, and nothing changes") {
  test::GuardedDaemon daemon;
  const std::string query = "?apikey=" + daemon.new_key(Scope::kAdmin);

  CHECK(daemon.get("/api/version" + query).status == 200);
  CHECK(daemon.get("/api/version?apikey=x").status == 403);
  CHECK(daemon.get("/api/v1/jobs" + query).status == 401);
  CHECK(daemon.get("/metrics" + query).status == 401);
  CHECK(daemon.post("/api/job" + query, R"({"command": "pause"})").status == 403);
}

TEST_CASE("The key in the data folder is an administrator's, wherever slicers show it") {
  const test::GuardedDaemon daemon;

  for (const std::string& head :
       {test::by_key(daemon.key()), "Authorization: Bearer " + daemon.key() + "\r\n"}) {
    CHECK(daemon.ask("GET", "/api/v1/keys", head).status == 200);
    CHECK(daemon.ask("GET", "/api/version", head).status == 200);
  }
  // A key that is wrong is wrong, whatever else is shown.
  CHECK(daemon.ask("GET", "/api/version", test::by_key("x")).status == 403);
}

TEST_CASE("OctoPrint's clients are told who they are") {
  test::GuardedDaemon daemon;
  const std::string print = test::by_key(daemon.new_key(Scope::kPrint));
  const std::string admin = test::by_key(daemon.new_key(Scope::kAdmin));
  const auto login = [&](const std::string& head) {
    return test::json_of(daemon.ask("POST", "/api/login", head, R"({"passive": true})"));
  };

  CHECK(login(print)["name"] == "test");
  CHECK(login(print)["admin"] == false);
  CHECK(login(admin)["admin"] == true);
  CHECK(test::json_of(daemon.ask("GET", "/api/currentuser", print))["groups"] ==
        json::array({"users"}));
}

TEST_CASE("The set-up sees which ports and profiles there are") {
  test::GuardedDaemon daemon;

  const auto about =
      test::json_of(daemon.ask("GET", "/api/v1/machine", test::from_page(daemon.new_session())));

  CHECK(about["printer"] == "sim:");
  CHECK(about["machine"] == "generic_marlin");
  CHECK(about["ports"].is_array());
  CHECK_THAT(about["machines"].dump(), Contains("\"ender3\""));
}
