// Accounts and sessions.
#include "host/serve/accounts.h"

#include "host/serve/secrets.h"

namespace slipstick {
namespace {

// How exactly it is known when something was last used: each note is a write to the disk.
constexpr std::int64_t kNotedEvery = 3600;

constexpr std::int64_t kIdle = Accounts::kIdleMost.count();
constexpr std::int64_t kAge = Accounts::kAgeMost.count();

}  // namespace

Result<Accounts> Accounts::open(const std::filesystem::path& folder) {
  auto database = Database::open(folder / "slipstick.db");
  if (!database) return fail(database.error());
  return Accounts(std::move(*database));
}

Result<bool> Accounts::is_there(std::string_view sql, const std::vector<SqlValue>& values) {
  const auto rows = database_.query(sql, values);
  if (!rows) return fail(rows.error());
  return !rows->empty();
}

Result<bool> Accounts::any() {
  return is_there("SELECT 1 FROM users LIMIT 1", {});
}

Result<std::optional<Accounts::User>> Accounts::find(std::string_view name) {
  const auto rows =
      database_.query("SELECT id, name, password FROM users WHERE name = ?1", {std::string(name)});
  if (!rows) return fail(rows.error());
  if (rows->empty()) return std::optional<User>();
  const SqlRow& row = rows->front();
  return User{row.integer(0), row.text(1), row.text(2)};
}

Result<std::optional<Accounts::User>> Accounts::add_first(const AccountName& name,
                                                          const std::string& password_hash,
                                                          std::int64_t now) {
  const auto added = database_.change(
      "INSERT INTO users (name, password, created) SELECT ?1, ?2, ?3 "
      "WHERE NOT EXISTS (SELECT 1 FROM users)",
      {name.text(), password_hash, now});
  if (!added) return fail(added.error());
  if (*added == 0) return std::optional<User>();
  return User{database_.last_id(), name.text(), password_hash};
}

Result<void> Accounts::change_password(std::int64_t user, const std::string& password_hash) {
  auto transaction = Database::Transaction::begin(database_);
  if (!transaction) return fail(transaction.error());
  const auto changed =
      database_.change("UPDATE users SET password = ?2 WHERE id = ?1", {user, password_hash});
  if (!changed) return fail(changed.error());
  if (const auto ok = end_sessions(user); !ok) return ok;
  return transaction->commit();
}

Result<void> Accounts::forget_all() {
  const auto changed = database_.change("DELETE FROM users");
  if (!changed) return fail(changed.error());
  return {};
}

Result<std::string> Accounts::begin_session(std::int64_t user, std::int64_t now) {
  std::string token = random_token();
  auto transaction = Database::Transaction::begin(database_);
  if (!transaction) return fail(transaction.error());
  const auto added =
      database_.change("INSERT INTO sessions (hash, user, created, seen) VALUES (?1, ?2, ?3, ?3)",
                       {token_hash(token), user, now});
  if (!added) return fail(added.error());
  if (const auto ok = end_surplus_sessions(user, now); !ok) return fail(ok.error());
  if (const auto ok = transaction->commit(); !ok) return fail(ok.error());
  return token;
}

Result<void> Accounts::end_surplus_sessions(std::int64_t user, std::int64_t now) {
  const auto expired = database_.change("DELETE FROM sessions WHERE created <= ?1 OR seen <= ?2",
                                        {now - kAge, now - kIdle});
  if (!expired) return fail(expired.error());
  const auto surplus = database_.change(
      "DELETE FROM sessions WHERE id IN (SELECT id FROM sessions WHERE user = ?1 "
      "ORDER BY id DESC LIMIT -1 OFFSET ?2)",
      {user, std::int64_t{kSessionsMax}});
  if (!surplus) return fail(surplus.error());
  return {};
}

Result<std::optional<Caller>> Accounts::session(std::string_view token, std::int64_t now) {
  const auto rows = database_.query(
      "SELECT sessions.id, users.id, users.name, sessions.seen FROM sessions "
      "JOIN users ON users.id = sessions.user "
      "WHERE hash = ?1 AND sessions.created > ?2 AND seen > ?3",
      {token_hash(token), now - kAge, now - kIdle});
  if (!rows) return fail(rows.error());
  if (rows->empty()) return std::optional<Caller>();
  const SqlRow& row = rows->front();
  note_use("UPDATE sessions SET seen = ?2 WHERE id = ?1", row.integer(0), row.integer(3), now);
  return Caller{Caller::By::kSession, Scope::kAdmin, row.integer(0), row.integer(1), row.text(2)};
}

// On a full disk as well somebody must get in, if only to stop the printer.
void Accounts::note_use(std::string_view sql, std::int64_t id, std::int64_t last,
                        std::int64_t now) {
  if (now - last < kNotedEvery) return;
  const auto ignored = database_.change(sql, {id, now});
  static_cast<void>(ignored);
}

Result<void> Accounts::end_session(std::int64_t id) {
  const auto ended = database_.change("DELETE FROM sessions WHERE id = ?1", {id});
  if (!ended) return fail(ended.error());
  return {};
}

Result<void> Accounts::end_sessions(std::int64_t user) {
  const auto ended = database_.change("DELETE FROM sessions WHERE user = ?1", {user});
  if (!ended) return fail(ended.error());
  return {};
}

Result<bool> Accounts::still_good(const Caller& caller, std::int64_t now) {
  if (caller.by == Caller::By::kSession) {
    return is_there("SELECT 1 FROM sessions WHERE id = ?1 AND created > ?2 AND seen > ?3",
                    {caller.id, now - kAge, now - kIdle});
  }
  if (caller.by == Caller::By::kKey) {
    return is_there("SELECT 1 FROM keys WHERE id = ?1", {caller.id});
  }
  if (caller.by != Caller::By::kMachine) return true;
  const auto there_are_accounts = any();
  if (!there_are_accounts) return fail(there_are_accounts.error());
  return !*there_are_accounts;
}

Result<Accounts::MadeKey> Accounts::add_key(std::int64_t user, const AccountName& name, Scope scope,
                                            std::int64_t now) {
  std::string token = random_token();
  const auto added = database_.change(
      "INSERT INTO keys (hash, user, name, scope, created) SELECT ?1, ?2, ?3, ?4, ?5 "
      "WHERE (SELECT count(*) FROM keys) < ?6",
      {token_hash(token), user, name.text(), std::string(name_of(scope)), now,
       std::int64_t{kKeysMax}});
  if (!added) return fail(added.error());
  if (*added == 0) {
    return fail(ErrorCode::kUnavailable, "there are 100 keys and no more are made; remove some");
  }
  return MadeKey{{database_.last_id(), name.text(), scope, now, 0}, std::move(token)};
}

Result<std::vector<Accounts::Key>> Accounts::keys() {
  const auto rows =
      database_.query("SELECT id, name, scope, created, used FROM keys ORDER BY id LIMIT ?1",
                      {std::int64_t{kKeysMax}});
  if (!rows) return fail(rows.error());
  std::vector<Key> keys;
  for (const SqlRow& row : *rows) {
    keys.push_back({row.integer(0), row.text(1), scope_named(row.text(2)).value_or(Scope::kRead),
                    row.integer(3), row.integer(4)});
  }
  return keys;
}

Result<bool> Accounts::remove_key(std::int64_t id) {
  const auto removed = database_.change("DELETE FROM keys WHERE id = ?1", {id});
  if (!removed) return fail(removed.error());
  return *removed == 1;
}

Result<std::optional<Caller>> Accounts::key(std::string_view token, std::int64_t now) {
  const auto rows = database_.query("SELECT id, user, name, scope, used FROM keys WHERE hash = ?1",
                                    {token_hash(token)});
  if (!rows) return fail(rows.error());
  if (rows->empty()) return std::optional<Caller>();
  const SqlRow& row = rows->front();
  note_use("UPDATE keys SET used = ?2 WHERE id = ?1", row.integer(0), row.integer(4), now);
  return Caller{Caller::By::kKey, scope_named(row.text(3)).value_or(Scope::kRead), row.integer(0),
                row.integer(1), row.text(2)};
}

}  // namespace slipstick
