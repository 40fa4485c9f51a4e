#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/serve/caller.h"
#include "host/serve/credentials.h"
#include "host/serve/database.h"

namespace slipstick {

/// Accounts, the sessions of browsers, and keys of programs, in the store's database. Of passwords
/// and tokens only hashes are kept. Errors of the disk are kUnavailable.
///
/// Tokens are looked up by their hashes: how long that takes tells of the hash of what was shown,
/// which nobody can choose.
///
/// Threads: one; another thread opens its own.
class Accounts {
 public:
  /// A session ends when it was not used for so long, and so long after its beginning at last.
  static constexpr std::chrono::seconds kIdleMost = std::chrono::hours(14 * 24);
  static constexpr std::chrono::seconds kAgeMost = std::chrono::hours(90 * 24);
  static constexpr int kSessionsMax = 32;  ///< Of one account; the oldest are ended.
  static constexpr int kKeysMax = 100;

  /// \pre the store of `folder` was opened once: it makes the tables.
  /// \param now seconds since 1970, wherever one is asked for.
  [[nodiscard]] static Result<Accounts> open(const std::filesystem::path& folder);

  struct User {
    std::int64_t id = 0;
    std::string name;
    std::string password;  ///< Its hash.
  };
  /// Whether there is any account.
  [[nodiscard]] Result<bool> any();
  /// Whatever the case of its letters A to Z.
  [[nodiscard]] Result<std::optional<User>> find(std::string_view name);
  /// \return nothing if there is an account already.
  [[nodiscard]] Result<std::optional<User>> add_first(const AccountName& name,
                                                      const std::string& password_hash,
                                                      std::int64_t now);
  /// Ends all sessions of it.
  [[nodiscard]] Result<void> change_password(std::int64_t user, const std::string& password_hash);
  /// Removes all accounts, with their sessions and keys.
  [[nodiscard]] Result<void> forget_all();

  /// \return the token, which is not kept.
  [[nodiscard]] Result<std::string> begin_session(std::int64_t user, std::int64_t now);
  /// Who shows `token`; notes that it was used.
  [[nodiscard]] Result<std::optional<Caller>> session(std::string_view token, std::int64_t now);
  [[nodiscard]] Result<void> end_session(std::int64_t id);
  [[nodiscard]] Result<void> end_sessions(std::int64_t user);

  struct Key {
    std::int64_t id = 0;
    std::string name;
    Scope scope = Scope::kRead;
    std::int64_t created = 0;
    std::int64_t used = 0;  ///< To the hour; 0: never.
  };
  struct MadeKey {
    Key key;
    std::string token;  ///< Not kept.
  };
  /// \return kUnavailable also if there are too many.
  [[nodiscard]] Result<MadeKey> add_key(std::int64_t user, const AccountName& name, Scope scope,
                                        std::int64_t now);
  [[nodiscard]] Result<std::vector<Key>> keys();
  /// \return whether there was one.
  [[nodiscard]] Result<bool> remove_key(std::int64_t id);
  /// Who shows `token`; notes that it was used.
  [[nodiscard]] Result<std::optional<Caller>> key(std::string_view token, std::int64_t now);

  /// Whether what he showed is still good; of who showed nothing, whether there is still no
  /// account.
  [[nodiscard]] Result<bool> still_good(const Caller& caller, std::int64_t now);

 private:
  explicit Accounts(Database database) : database_(std::move(database)) {}
  [[nodiscard]] Result<void> end_surplus_sessions(std::int64_t user, std::int64_t now);
  void note_use(std::string_view sql, std::int64_t id, std::int64_t last, std::int64_t now);
  [[nodiscard]] Result<bool> is_there(std::string_view sql, const std::vector<SqlValue>& values);

  Database database_;
};

}  // namespace slipstick
