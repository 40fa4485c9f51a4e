// Accounts, sessions and keys as they are kept; passwords; how soon somebody may try again.
#include <catch2/catch.hpp>
#include <cctype>
#include <fstream>

#include "host/serve/login_limiter.h"
#include "host/serve/setup_code.h"
#include "tests/host/guarded_daemon.h"

using namespace slipstick;
using namespace std::chrono_literals;
using Catch::Contains;
using Catch::StartsWith;

namespace {

// Accounts, and verbs for what is done with them.
struct Register {
  test::TemporaryFolder folder;
  Accounts accounts = test::accounts_in(folder.path());

  std::int64_t add(const char* name) {
    return (**accounts.add_first(*AccountName::from(name), "hash", 100)).id;
  }
  std::string key(std::int64_t user, Scope scope) {
    return (*accounts.add_key(user, *AccountName::from("slicer"), scope, 100)).token;
  }
  bool session_is_good(const std::string& token, std::int64_t now) {
    return (*accounts.session(token, now)).has_value();
  }
  std::string bytes() {
    std::string all;
    for (const char* name : {"slipstick.db", "slipstick.db-wal"}) {
      std::ifstream file(folder.path() / name, std::ios::binary);
      all.append(std::istreambuf_iterator<char>(file), {});
    }
    return all;
  }
};

std::string fault_of_name(std::string_view text) {
  const auto name = AccountName::from(text);
  return name ? "" : name.error().message;
}

std::string fault_of_password(std::string_view text) {
  const auto password = NewPassword::from(text, *AccountName::from("ada lovelace"));
  return password ? "" : password.error().message;
}

std::filesystem::perms rights_of(const std::filesystem::path& file) {
  return std::filesystem::status(file).permissions() & std::filesystem::perms(0777);
}

}  // namespace

TEST_CASE("A password is known again by its hash, all of it, and no other is") {
  const std::string longer = std::string(200, 'x') + std::string("\0y", 2);
  const std::string hash = *password_hash(longer);

  CHECK_THAT(hash, StartsWith("$argon2id$"));
  CHECK(password_matches(hash, longer));
  CHECK(!password_matches(hash, longer.substr(0, longer.size() - 1)));
  CHECK(!password_matches(hash, std::string(200, 'x')));
  CHECK(!password_matches(hash, ""));
  CHECK(!password_matches("", ""));
  CHECK(!password_matches("no hash", "no hash"));
}

TEST_CASE("The hash of nobody takes as long as that of anybody") {
  const std::string hash = *password_hash("anybody's");
  const auto costs = [](const std::string& text) { return text.substr(0, text.rfind(",p=1$")); };

  CHECK(hash != *password_hash("anybody's"));  // salted
  CHECK(costs(hash_of_nobody()) == costs(hash));
  CHECK(hash_of_nobody().size() == hash.size());
  CHECK(!password_matches(hash_of_nobody(), ""));
}

TEST_CASE("Tokens are made by chance, and kept as hashes of one size") {
  CHECK(random_token().size() == 64);
  CHECK(random_token() != random_token());
  CHECK(random_code(12).size() == 12);
  CHECK(random_code(12) != random_code(12));
  CHECK(token_hash("a").size() == token_hash("").size());
  CHECK(token_hash("a") != token_hash("b"));
  CHECK(equal_in_constant_time("ab", "ab"));
  CHECK(!equal_in_constant_time("ab", "aB"));
  CHECK(!equal_in_constant_time("ab", "abc"));
}

TEST_CASE("A name has no characters that fool a reader") {
  CHECK(fault_of_name("Ada Lovelace").empty());
  CHECK(fault_of_name(std::string(64, 'a')).empty());
  CHECK_THAT(fault_of_name(""), Contains("empty"));
  CHECK_THAT(fault_of_name(std::string(65, 'a')), Contains("64"));
  CHECK_THAT(fault_of_name("ada\n"), Contains("control"));
  CHECK_THAT(fault_of_name(" ada"), Contains("blank"));
  CHECK_THAT(fault_of_name("ada "), Contains("blank"));
}

TEST_CASE("A password is long enough, and whatever else its owner likes") {
  CHECK(fault_of_password("0123456789").empty());
  CHECK(fault_of_password("\xc3\xa4 \xe2\x82\xac 345678").empty());  // 10 characters of 13 bytes
  CHECK(fault_of_password(std::string(1024, 'x')).empty());
  CHECK_THAT(fault_of_password("012345678"), Contains("10 characters"));
  CHECK_THAT(fault_of_password("\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4"), Contains("10"));
  CHECK_THAT(fault_of_password(std::string(1025, 'x')), Contains("1024"));
  CHECK_THAT(fault_of_password("ada lovelace"), Contains("name"));
}

TEST_CASE("Only the first account is made by the set-up") {
  Register all;
  CHECK(*all.accounts.any() == false);
  CHECK((*all.accounts.add_first(*AccountName::from("ada"), "hash", 100)).has_value());

  CHECK(!*all.accounts.add_first(*AccountName::from("eve"), "hash", 100));

  CHECK(*all.accounts.any() == true);
  CHECK((**all.accounts.find("ADA")).name == "ada");
  CHECK(!*all.accounts.find("eve"));
}

TEST_CASE("A session ends when it was not used for long, and at last however often it was") {
  Register all;
  const std::int64_t idle = Accounts::kIdleMost.count(), age = Accounts::kAgeMost.count();
  const auto user = all.add("ada");
  const std::string unused = *all.accounts.begin_session(user, 100);
  const std::string used = *all.accounts.begin_session(user, 100);

  CHECK(all.session_is_good(unused, 100 + idle - 1));  // which is a use
  CHECK(all.session_is_good(unused, 100 + 2 * idle - 2));
  CHECK(!all.session_is_good(unused, 100 + 4 * idle));
  CHECK(!all.session_is_good(unused, 100 + 3 * idle - 1));
  std::int64_t now = 100;
  for (; now < 100 + age; now += idle / 2) CHECK(all.session_is_good(used, now));
  CHECK(!all.session_is_good(used, 100 + age));
  CHECK(!all.session_is_good("", 100));
  CHECK(!all.session_is_good(std::string(64, '0'), 100));
}

TEST_CASE("Sessions are ended one by one, all of one account, or by another password") {
  Register all;
  const auto user = all.add("ada");
  const std::string first = *all.accounts.begin_session(user, 100);
  const std::string second = *all.accounts.begin_session(user, 100);
  const std::string third = *all.accounts.begin_session(user, 100);
  const Caller caller = **all.accounts.session(first, 100);
  CHECK(caller.name == "ada");
  CHECK(caller.scope == Scope::kAdmin);

  CHECK(*all.accounts.still_good(caller, 100) == true);
  REQUIRE(all.accounts.end_session(caller.id));
  CHECK(*all.accounts.still_good(caller, 100) == false);
  CHECK(!all.session_is_good(first, 100));
  CHECK(all.session_is_good(second, 100));

  REQUIRE(all.accounts.change_password(user, "another"));
  CHECK(!all.session_is_good(second, 100));
  CHECK(!all.session_is_good(third, 100));
  CHECK((**all.accounts.find("ada")).password == "another");
}

TEST_CASE("An account has a bounded number of sessions; the oldest are ended") {
  Register all;
  const auto user = all.add("ada");
  const std::string first = *all.accounts.begin_session(user, 100);
  const std::string second = *all.accounts.begin_session(user, 100);

  for (int i = 1; i < Accounts::kSessionsMax; ++i) REQUIRE(all.accounts.begin_session(user, 100));

  CHECK(!all.session_is_good(first, 100));
  CHECK(all.session_is_good(second, 100));
}

TEST_CASE(
    "A key has a name and a scope, is known until it is removed, and tells when it was used") {
  Register all;
  const auto user = all.add("ada");
  const std::string token = all.key(user, Scope::kPrint);
  CHECK((*all.accounts.keys()).at(0).used == 0);

  const Caller caller = **all.accounts.key(token, 5'000);

  CHECK(caller.by == Caller::By::kKey);
  CHECK(caller.scope == Scope::kPrint);
  CHECK((*all.accounts.keys()).at(0).used == 5'000);
  CHECK(*all.accounts.still_good(caller, 5'000) == true);
  CHECK(*all.accounts.remove_key(caller.id) == true);
  CHECK(*all.accounts.remove_key(caller.id) == false);
  CHECK(!*all.accounts.key(token, 5'000));
  CHECK(*all.accounts.still_good(caller, 5'000) == false);
}

TEST_CASE("There is a bounded number of keys") {
  Register all;
  const auto user = all.add("ada");
  for (int i = 0; i < Accounts::kKeysMax; ++i) static_cast<void>(all.key(user, Scope::kRead));

  const auto refused = all.accounts.add_key(user, *AccountName::from("x"), Scope::kRead, 100);

  REQUIRE(!refused);
  CHECK_THAT(refused.error().message, Contains("100 keys"));
}

TEST_CASE("When accounts are forgotten, their sessions and keys are") {
  Register all;
  const auto user = all.add("ada");
  const std::string session = *all.accounts.begin_session(user, 100);
  const std::string key = all.key(user, Scope::kAdmin);

  REQUIRE(all.accounts.forget_all());

  CHECK(*all.accounts.any() == false);
  CHECK(!all.session_is_good(session, 100));
  CHECK(!*all.accounts.key(key, 100));
}

TEST_CASE("Neither tokens nor keys are in the database, which is its owner's alone") {
  Register all;
  const auto user = all.add("ada");
  const std::string session = *all.accounts.begin_session(user, 100);
  const std::string key = all.key(user, Scope::kAdmin);

  const std::string bytes = all.bytes();

  CHECK(bytes.find(token_hash(session)) != bytes.npos);
  CHECK(bytes.find(session) == bytes.npos);
  CHECK(bytes.find(key) == bytes.npos);
  for (const char* name : {"slipstick.db", "slipstick.db-wal", "slipstick.db-shm"}) {
    INFO(name);
    CHECK(rights_of(all.folder.path() / name) == std::filesystem::perms(0600));
  }
}

TEST_CASE("A database that others could read is made its owner's alone") {
  const test::TemporaryFolder folder;
  static_cast<void>(test::accounts_in(folder.path()));
  std::filesystem::permissions(folder.path() / "slipstick.db", std::filesystem::perms(0644));

  static_cast<void>(test::accounts_in(folder.path()));

  CHECK(rights_of(folder.path() / "slipstick.db") == std::filesystem::perms(0600));
}

TEST_CASE("The code of the set-up is kept for its owner alone, and read as people type it") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "setup_code";
  const auto code = SetupCode::load_or_make(path);
  REQUIRE(code);
  std::string typed = code->text();
  CHECK(typed.size() == 14);

  CHECK(code->is(typed));
  std::erase(typed, '-');
  for (char& c : typed) c = static_cast<char>(std::tolower(c));
  CHECK(code->is(typed + " "));
  CHECK(!code->is(typed.substr(1)));
  CHECK(!code->is(""));
  CHECK((*SetupCode::load_or_make(path)).text() == code->text());
  CHECK(rights_of(path) == std::filesystem::perms(0600));
  code->forget();
  CHECK(!std::filesystem::exists(path));
}

TEST_CASE("After a few mistakes each next try waits twice as long, by account and by address") {
  LoginLimiter limiter;
  const LoginLimiter::Time start{};
  for (int i = 0; i < LoginLimiter::kFree; ++i) {
    CHECK(limiter.wait("ada", "192.0.2.1", start) == 0s);
    limiter.failed("ada", "192.0.2.1", start);
  }
  CHECK(limiter.wait("ada", "192.0.2.1", start) == 0s);

  for (const auto pause : {1s, 2s, 4s, 8s, 16s}) {
    limiter.failed("Ada", "192.0.2.1", start);
    CHECK(limiter.wait("ada", "192.0.2.2", start) == pause);
    CHECK(limiter.wait("eve", "192.0.2.1", start) == pause);
    CHECK(limiter.wait("ada", "192.0.2.1", start + pause) == 0s);
  }
  for (int i = 0; i < 100; ++i) limiter.failed("ada", "192.0.2.1", start);
  CHECK(limiter.wait("ada", "192.0.2.2", start) == LoginLimiter::kAccountMost);
  CHECK(limiter.wait("eve", "192.0.2.1", start) == LoginLimiter::kAddressMost);
  CHECK(limiter.wait("eve", "192.0.2.2", start) == 0s);
}

TEST_CASE("Mistakes are forgotten after the right password, and after a while") {
  LoginLimiter limiter;
  const LoginLimiter::Time start{};
  for (int i = 0; i < 7; ++i) limiter.failed("ada", "192.0.2.1", start);
  for (int i = 0; i < 7; ++i) limiter.failed("bob", "192.0.2.2", start);

  limiter.succeeded("ada", "192.0.2.1");
  CHECK(limiter.wait("ada", "192.0.2.1", start) == 0s);

  const auto later = start + LoginLimiter::kForgotten + 10s;
  limiter.failed("bob", "192.0.2.2", later);
  CHECK(limiter.wait("bob", "192.0.2.2", later) == 0s);
}

TEST_CASE("Names and addresses that are made up do not drive out whoever has to wait") {
  LoginLimiter limiter;
  const LoginLimiter::Time start{};
  for (int i = 0; i < 20; ++i) limiter.failed("ada", "192.0.2.1", start);

  for (std::size_t i = 0; i < 3 * LoginLimiter::kTableMax; ++i) {
    limiter.failed("made up " + std::to_string(i), "address " + std::to_string(i), start);
  }

  CHECK(limiter.wait("ada", "192.0.2.2", start) == LoginLimiter::kAccountMost);
  CHECK(limiter.wait("eve", "192.0.2.1", start) == LoginLimiter::kAddressMost);
}
