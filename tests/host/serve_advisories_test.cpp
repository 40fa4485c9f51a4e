// What was found wrong with other daemons for printers over the years, and is held against this
// one: each test shows that the same mistake is not here.
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>

#include "host/serve/web_assets.h"
#include "tests/host/guarded_daemon.h"

using namespace slipstick;
using Catch::Contains;
using nlohmann::json;

namespace {

std::string part(const std::string& name, const std::string& value) {
  return "--b\r\nContent-Disposition: form-data; name=\"" + name + "\"\r\n\r\n" + value + "\r\n";
}

std::string file_part(const std::string& name, const std::string& bytes) {
  return "--b\r\nContent-Disposition: form-data; name=\"file\"; filename=\"" + name + "\"\r\n\r\n" +
         bytes + "\r\n";
}

constexpr const char* kForm = "Content-Type: multipart/form-data; boundary=b\r\n";

test::HttpReply upload(const test::GuardedDaemon& daemon, const std::string& head,
                       const std::string& body) {
  return daemon.ask("POST", "/api/files/local", head + kForm, body);
}

std::size_t files_of(test::GuardedDaemon& daemon) {
  const auto listed = daemon.ask("GET", "/api/v1/files", test::by_key(daemon.key()));
  return test::json_of(listed)["files"].size();
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("CVE-2026-23892: keys are compared by hashes, which have one size and one time") {
  test::GuardedDaemon daemon;
  const std::string key = daemon.new_key(Scope::kAdmin);
  for (const std::string& right : {key, daemon.key()}) {
    for (std::size_t wrong = 0; wrong < right.size(); wrong += 9) {
      std::string guess = right;
      guess[wrong] = guess[wrong] == '0' ? '1' : '0';
      CHECK(daemon.ask("GET", "/api/v1/jobs", test::by_key(guess)).status == 401);
      CHECK(daemon.ask("GET", "/api/v1/jobs", test::by_key(right.substr(0, wrong))).status == 401);
    }
    CHECK(daemon.ask("GET", "/api/v1/jobs", test::by_key(right)).status == 200);
  }
  CHECK(text_of(daemon.data() / "slipstick.db-wal").find(key) == std::string::npos);
}

TEST_CASE("CVE-2025-48067, CVE-2026-54134: no field of a form names a file of the server") {
  test::GuardedDaemon daemon;
  const auto secret = daemon.data() / "secret.gcode";
  std::ofstream(secret) << "M117 secret\n";
  const std::string key = test::by_key(daemon.key());
  std::string fields;
  for (const char* name : {"file.path", "file.name", "file", "path", "file.content_type",
                           "file_path", "file.path\\", "FILE.PATH"}) {
    fields += part(name, secret.string());
  }

  CHECK(upload(daemon, key, fields + "--b--\r\n").status == 400);
  CHECK(files_of(daemon) == 0);
  CHECK(upload(daemon, key, fields + file_part("a.gcode", "G28\n") + "--b--\r\n").status == 201);

  CHECK(text_of(daemon.data() / "files" / "1.gcode") == "G28\n");
  CHECK(text_of(secret) == "M117 secret\n");
}

TEST_CASE("CVE-2025-64187, CVE-2024-49377, CVE-2022-1430: no text can become markup on the page") {
  for (const WebAsset& asset : web_assets()) {
    INFO(asset.name);
    for (const char* sink : {"innerHTML", "outerHTML", "insertAdjacentHTML", "document.write",
                             "createContextualFragment", "eval(", "new Function",
                             "javascript:", "setTimeout('", "srcdoc", "DOMParser"}) {
      INFO(sink);
      CHECK(asset.text.find(sink) == asset.text.npos);
    }
    if (!asset.name.ends_with(".html")) continue;
    const std::regex inline_code(R"(<script>|<style|\son[a-z]+=|\sstyle=)");
    CHECK(!std::regex_search(asset.text.begin(), asset.text.end(), inline_code));
  }
  const test::GuardedDaemon daemon;
  for (const char* page : {"/", "/login", "/setup"}) {
    const std::string policy = daemon.get(page).headers.at("content-security-policy");
    CHECK_THAT(policy, Contains("default-src 'none'") && Contains("script-src 'self'") &&
                           Contains("frame-ancestors 'none'") && !Contains("unsafe"));
  }
}

TEST_CASE("CVE-2024-49377: nothing in an address comes back as anything but quoted text") {
  test::GuardedDaemon daemon;
  const std::string script = "%3Cscript%3Ealert(1)%3C%2Fscript%3E";

  for (const std::string& target :
       {"/login?redirect=" + script, "/setup?" + script, "/?user=" + script}) {
    CHECK(daemon.get(target).body == daemon.get(target.substr(0, target.find('?'))).body);
  }
  for (const std::string& target : {"/" + script, "/api/v1/files/" + script, "/assets/" + script}) {
    const auto reply = daemon.ask("GET", target, test::by_key(daemon.key()));
    CHECK(reply.status == 404);
    CHECK(reply.headers.at("content-type") == "application/json");
    CHECK(reply.headers.at("x-content-type-options") == "nosniff");
  }
}

TEST_CASE("CVE-2022-1432: no parameter says where a login leads") {
  for (const WebAsset& asset : web_assets()) {
    INFO(asset.name);
    for (const char* source : {"location.search", "location.hash", "URLSearchParams",
                               "document.referrer", "window.name"}) {
      CHECK(asset.text.find(source) == asset.text.npos);
    }
  }
  const test::GuardedDaemon daemon;
  const auto reply = daemon.ask("POST", "/api/v1/login?redirect=//evil.example", "",
                                R"({"name": "ada", "password": "correct horse battery"})");
  CHECK(reply.status == 200);
  CHECK(!reply.headers.contains("location"));
}

TEST_CASE("CVE-2024-32977: no header says where a request comes from, or that it is let in") {
  const test::GuardedDaemon daemon;

  for (const char* head :
       {"X-Forwarded-For: 127.0.0.1\r\n", "X-Real-IP: 127.0.0.1\r\n", "X-Client-IP: 127.0.0.1\r\n",
        "Forwarded: for=127.0.0.1\r\n", "X-Forwarded-For: ::1\r\nX-Forwarded-Host: localhost\r\n",
        "X-Remote-User: ada\r\n", "Remote-User: ada\r\n", "X-Preemptive-Recording: yes\r\n",
        "Authorization: Basic YWRhOmNvcnJlY3QgaG9yc2UgYmF0dGVyeQ==\r\n"}) {
    INFO(head);
    CHECK(daemon.ask("GET", "/api/v1/printer", head).status == 401);
    CHECK(daemon.ask("GET", "/api/printer", head).status == 403);
  }
}

TEST_CASE("CVE-2024-32977: mistakes count for the address they come from, whatever it claims") {
  const test::GuardedDaemon daemon;
  const auto guess = [&](int i) {
    const std::string name = "guess " + std::to_string(i);
    const std::string claim = "X-Forwarded-For: 192.0.2." + std::to_string(i) + "\r\n";
    return daemon.log_in(name, "a wrong one", claim);
  };

  CHECK(test::slowed_down(guess).status == 429);
}

TEST_CASE("CVE-2022-2888: a session that was ended is good for nothing, and each ends at last") {
  test::GuardedDaemon daemon;
  const std::string page = test::from_page(daemon.new_session());
  const std::string old = *daemon.accounts().begin_session(
      daemon.ada(), test::seconds_now() - Accounts::kAgeMost.count());
  CHECK(daemon.ask("GET", "/api/v1/jobs", page).status == 200);
  CHECK(daemon.ask("GET", "/api/v1/jobs", test::from_page(old)).status == 401);

  CHECK(daemon.ask("POST", "/api/v1/logout", page).status == 204);

  CHECK(daemon.ask("GET", "/api/v1/jobs", page).status == 401);
}

TEST_CASE("CVE-2022-2822: passwords cannot be tried one after the other") {
  const test::GuardedDaemon daemon;
  int looked_at = 0;
  for (int i = 0; i < 30; ++i) looked_at += daemon.log_in(test::kAda, "guess").status == 403;

  CHECK(looked_at < 12);
}

TEST_CASE("CVE-2022-2872: nothing that was uploaded is ever sent as a page") {
  test::GuardedDaemon daemon;
  const std::string key = test::by_key(daemon.key());
  const std::string page = "<script>alert(1)</script>";

  for (const char* name : {"a.html", "a.svg", "a.js", "a.gcode.html", "a.xhtml", "a.htm"}) {
    INFO(name);
    CHECK(daemon.ask("PUT", "/api/v1/files/" + std::string(name), key, page).status == 400);
    CHECK(upload(daemon, key, file_part(name, page) + "--b--\r\n").status >= 400);
  }
  CHECK(files_of(daemon) == 0);
  REQUIRE(daemon.ask("PUT", "/api/v1/files/a.gcode", key, page).status == 201);
  for (const char* target : {"/api/v1/files/a.gcode", "/api/files/local/a.gcode", "/a.gcode",
                             "/files/1.gcode", "/downloads/files/local/a.gcode"}) {
    INFO(target);
    const auto reply = daemon.ask("GET", target, key);
    CHECK(reply.body.find(page) == std::string::npos);
    CHECK(reply.headers.at("content-type") == "application/json");
    CHECK(reply.headers.at("x-content-type-options") == "nosniff");
  }
}

TEST_CASE("CVE-2023-41047: a script that is uploaded describes a solid, and reaches nothing else") {
  test::GuardedDaemon daemon;
  const std::string key = test::by_key(daemon.key());
  const auto mark = daemon.data() / "mark";
  const std::string end = "\nreturn sphere(10)\n";
  REQUIRE(daemon.ask("PUT", "/api/v1/files/a.lua", key, end).status == 201);
  CHECK(daemon.ask("GET", "/api/v1/files/a.lua/layers", key).status == 200);

  for (const std::string& script :
       {"os.execute('touch " + mark.string() + "')" + end,
        "io.open('" + mark.string() + "', 'w')" + end, "dofile('/etc/passwd')" + end,
        "loadfile('/etc/passwd')()" + end, "require('os')" + end, "debug.getregistry()" + end,
        "package.loadlib('libc.so.6', 'system')" + end}) {
    INFO(script);
    REQUIRE(daemon.ask("PUT", "/api/v1/files/a.lua", key, script).status == 201);
    CHECK(daemon.ask("GET", "/api/v1/files/a.lua/layers", key).status == 400);
  }
  CHECK(!std::filesystem::exists(mark));
}

TEST_CASE("CVE-2024-23637, CVE-2024-51493: a session alone changes no password and makes no key") {
  test::GuardedDaemon daemon;
  const std::string page = test::from_page(daemon.new_session());

  for (const char* password : {"", "a wrong one"}) {
    const json change{{"old", password}, {"new", "0123456789"}};
    CHECK(daemon.ask("POST", "/api/v1/password", page, change.dump()).status == 403);
    const json key{{"name", "x"}, {"scope", "read"}, {"password", password}};
    CHECK(daemon.ask("POST", "/api/v1/keys", page, key.dump()).status == 403);
  }
  for (const std::string& key : {daemon.key(), daemon.new_key(Scope::kAdmin)}) {
    const json change{{"old", test::kPassword}, {"new", "0123456789"}};
    CHECK(daemon.ask("POST", "/api/v1/password", test::by_key(key), change.dump()).status == 403);
  }
  CHECK((*daemon.accounts().keys()).size() == 1);
}

TEST_CASE("CVE-2025-58180: no name of a file reaches a shell: there is none") {
  const std::regex shell(R"(\b(system|popen|execl|execlp|execvp|wordexp|posix_spawnp)\s*\()");
  std::size_t files = 0;
  for (const char* folder : {"core", "drivers", "sim", "host"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(SLIPSTICK_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      ++files;
      INFO(entry.path());
      CHECK(!std::regex_search(text_of(entry.path()), shell));
    }
  }
  CHECK(files > 100);
  test::GuardedDaemon daemon;
  const std::string name = "%24(touch%20mark)%3B%60id%60.gcode";
  const std::string key = test::by_key(daemon.key());
  CHECK(daemon.ask("PUT", "/api/v1/files/" + name, key, "G28\n").status == 201);
  CHECK(daemon.ask("DELETE", "/api/v1/files/" + name, key).status == 204);
}

TEST_CASE("CVE-2025-48879: a form without its end is refused, and holds nothing up") {
  test::GuardedDaemon daemon;
  const std::string key = test::by_key(daemon.key());

  for (const std::string& body :
       {file_part("a.gcode", "G28\n"), file_part("a.gcode", "G28\n") + "--b", std::string("--b"),
        std::string("no form"), std::string()}) {
    INFO(body);
    CHECK(upload(daemon, key, body).status == 400);
  }
  CHECK(files_of(daemon) == 0);
}

TEST_CASE("Pages of other sites post nothing by the cookie of who is logged in") {
  test::GuardedDaemon daemon;
  const std::string cookie = "Cookie: slipstick=" + daemon.new_session() + "\r\n";
  const std::string body = file_part("a.gcode", "G28\n") + "--b--\r\n";

  for (const char* site :
       {"", "Origin: http://evil.example\r\n", "Origin: null\r\n", "Sec-Fetch-Site: cross-site\r\n",
        "Referer: http://localhost/\r\n", "X-Requested-With: XMLHttpRequest\r\n"}) {
    INFO(site);
    CHECK(upload(daemon, cookie + site, body).status == 403);
    CHECK(daemon.ask("POST", "/api/v1/printer/emergency-stop", cookie + site).status == 403);
  }
  CHECK(files_of(daemon) == 0);
}

TEST_CASE(
    "A daemon that the network can reach is closed from the start, without a password that all "
    "know") {
  const test::RunningDaemon daemon("sim:", test::kNeedsKey);

  for (const Route& route : routes()) {
    if (route.access == RouteAccess::kAnyone || route.method != HttpMethod::kGet) continue;
    INFO(route.pattern);
    const int status = daemon.get(route.pattern).status;
    CHECK((status == 401 || status == 403));
  }
  for (const char* name : {"admin", "slipstick", "pi", "root", ""}) {
    const json shown{{"name", name}, {"password", name}};
    CHECK(daemon.post("/api/v1/login", shown.dump()).status == 403);
  }
}
