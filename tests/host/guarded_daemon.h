#pragma once

#include "host/serve/accounts.h"
#include "host/serve/secrets.h"
#include "tests/host/serve_fixture.h"

namespace slipstick::test {

inline constexpr const char* kAda = "ada";
inline constexpr const char* kPassword = "correct horse battery";

inline std::int64_t seconds_now() {
  return std::int64_t{std::time(nullptr)};
}

/// The database of the accounts of a folder, beside a daemon or without one.
inline Accounts accounts_in(const std::filesystem::path& folder) {
  REQUIRE(Store::open(folder));  // makes the tables
  auto accounts = Accounts::open(folder);
  REQUIRE(accounts);
  return std::move(*accounts);
}

/// What the page's own requests say: of a browser that is at http://localhost.
inline std::string from_page(const std::string& session) {
  return "Cookie: slipstick=" + session + "\r\nOrigin: http://localhost\r\n";
}

/// The token in an answer's cookie.
inline std::string session_in(const HttpReply& reply) {
  INFO(reply.status << " " << reply.body);
  REQUIRE(reply.headers.contains("set-cookie"));
  const std::string& cookie = reply.headers.at("set-cookie");
  REQUIRE(cookie.starts_with("slipstick="));
  return cookie.substr(10, cookie.find(';') - 10);
}

/// A daemon that other machines could reach, with the account of Ada.
class GuardedDaemon : public RunningDaemon {
 public:
  explicit GuardedDaemon(const HttpLimits& limits = {})
      : RunningDaemon("sim:", kNeedsKey, limits), accounts_(accounts_in(data())) {
    static const std::string kHash = *password_hash(kPassword);  // takes long
    const auto ada = accounts_.add_first(*AccountName::from(kAda), kHash, seconds_now());
    REQUIRE(ada);
    ada_ = (**ada).id;
  }

  [[nodiscard]] HttpReply ask(std::string_view method, std::string_view target,
                              const std::string& head = "", std::string_view body = "") const {
    return request(port(), method, target, body, head);
  }
  [[nodiscard]] HttpReply log_in(const std::string& name, const std::string& password,
                                 const std::string& head = "") const {
    return ask("POST", "/api/v1/login", head,
               nlohmann::json{{"name", name}, {"password", password}}.dump());
  }
  /// Without a password.
  [[nodiscard]] std::string new_session() { return *accounts_.begin_session(ada_, seconds_now()); }
  [[nodiscard]] std::string new_key(Scope scope) {
    return (*accounts_.add_key(ada_, *AccountName::from("test"), scope, seconds_now())).token;
  }
  [[nodiscard]] Accounts& accounts() { return accounts_; }
  [[nodiscard]] std::int64_t ada() const { return ada_; }

 private:
  Accounts accounts_;
  std::int64_t ada_ = 0;
};

/// The first answer that is not 403, of as many tries as the slowest machine needs: each mistake
/// that is looked at makes the time to wait longer.
template <typename Try>
[[nodiscard]] HttpReply slowed_down(Try attempt) {
  HttpReply reply;
  for (int i = 0; i < 40; ++i) {
    reply = attempt(i);
    if (reply.status != 403) break;
  }
  return reply;
}

inline std::string by_key(const std::string& key) {
  return "X-Api-Key: " + key + "\r\n";
}

}  // namespace slipstick::test
