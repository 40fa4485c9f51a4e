#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"

struct sqlite3;

namespace slipstick {

using SqlValue = std::variant<std::int64_t, std::string>;

/// One row of an answer. \pre of the getters: the column exists and has that type, which the caller
/// knows from his own statement and the schema; NULL is 0 or empty.
class SqlRow {
 public:
  explicit SqlRow(std::vector<SqlValue> values) : values_(std::move(values)) {}
  [[nodiscard]] std::int64_t integer(std::size_t column) const {
    return std::get<std::int64_t>(values_[column]);
  }
  [[nodiscard]] const std::string& text(std::size_t column) const {
    return std::get<std::string>(values_[column]);
  }

 private:
  std::vector<SqlValue> values_;
};

/// A connection to an SQLite file: write-ahead log, every commit on the disk before it returns,
/// foreign keys checked; for its owner only. Errors are kUnavailable and name the file.
///
/// Threads: one; another thread opens its own.
class Database {
 public:
  /// Opens or makes it. \return kUnavailable also if `PRAGMA quick_check` finds damage.
  [[nodiscard]] static Result<Database> open(const std::filesystem::path& path);

  /// Runs one statement. \return all rows: bound them by LIMIT.
  Result<std::vector<SqlRow>> query(std::string_view sql, const std::vector<SqlValue>& values = {});
  /// Runs one statement that gives no rows. \return how many rows it changed.
  Result<int> change(std::string_view sql, const std::vector<SqlValue>& values = {});
  [[nodiscard]] std::int64_t last_id() const;

  /// Everything between its making and `commit` happens or does not.
  class Transaction {
   public:
    [[nodiscard]] static Result<Transaction> begin(Database& database);
    Transaction(Transaction&& other) noexcept : database_(std::exchange(other.database_, {})) {}
    Transaction& operator=(Transaction&&) = delete;
    ~Transaction();
    [[nodiscard]] Result<void> commit();

   private:
    explicit Transaction(Database& database) : database_(&database) {}
    Database* database_;  // empty once over
  };

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  Database(std::filesystem::path path, sqlite3* handle) : path_(std::move(path)), handle_(handle) {}
  [[nodiscard]] Error error() const;

  std::filesystem::path path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

}  // namespace slipstick
