#include "host/serve/database.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/check.h"

namespace slipstick {
namespace {

// How long another connection of this program may hold the file.
constexpr int kBusyMilliseconds = 10'000;

struct Finalise {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, Finalise>;

int bind(sqlite3_stmt* statement, int place, const SqlValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) {
    return sqlite3_bind_int64(statement, place, *number);
  }
  const auto& text = std::get<std::string>(value);
  return sqlite3_bind_text64(statement, place, text.data(), text.size(), SQLITE_TRANSIENT,
                             SQLITE_UTF8);
}

SqlValue column(sqlite3_stmt* statement, int at) {
  if (sqlite3_column_type(statement, at) == SQLITE_INTEGER) {
    return std::int64_t{sqlite3_column_int64(statement, at)};
  }
  const void* bytes = sqlite3_column_blob(statement, at);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, at));
  return bytes == nullptr ? std::string() : std::string(static_cast<const char*>(bytes), size);
}

SqlRow row(sqlite3_stmt* statement) {
  std::vector<SqlValue> values;
  const int count = sqlite3_column_count(statement);
  values.reserve(static_cast<std::size_t>(count));
  for (int at = 0; at < count; ++at) values.push_back(column(statement, at));
  return SqlRow(std::move(values));
}

// Hashes of passwords are in it. SQLite gives its other files the rights of the first; those that
// were made before have others. Where it fails, opening tells why. A file that is there is not
// opened: closing it would end the locks that another connection of this program has.
void keep_private(const std::filesystem::path& path) {
  const int made = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (made >= 0) ::close(made);
  for (const char* end : {"", "-wal", "-shm"}) ::chmod((path.string() + end).c_str(), 0600);
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const {
  sqlite3_close_v2(handle);
}

Result<Database> Database::open(const std::filesystem::path& path) {
  keep_private(path);
  sqlite3* handle = nullptr;
  const int opened =
      sqlite3_open_v2(path.c_str(), &handle,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  Database database(path, handle);
  if (opened != SQLITE_OK) return fail(database.error());
  sqlite3_busy_timeout(handle, kBusyMilliseconds);
  for (const char* pragma : {"PRAGMA journal_mode=WAL", "PRAGMA synchronous=FULL",
                             "PRAGMA foreign_keys=ON", "PRAGMA trusted_schema=OFF"}) {
    if (const auto ok = database.query(pragma); !ok) return fail(ok.error());
  }
  const auto sound = database.query("PRAGMA quick_check(1)");
  if (!sound) return fail(sound.error());
  if (sound->size() == 1 && (*sound)[0].text(0) == "ok") return database;
  return fail(ErrorCode::kUnavailable,
              fmt::format("{} is damaged; move it away, or restore it from a copy", path.string()));
}

Result<std::vector<SqlRow>> Database::query(std::string_view sql,
                                            const std::vector<SqlValue>& values) {
  sqlite3_stmt* raw = nullptr;
  if (sqlite3_prepare_v2(handle_.get(), sql.data(), static_cast<int>(sql.size()), &raw, nullptr) !=
      SQLITE_OK) {
    return fail(error());
  }
  const Statement statement(raw);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (bind(raw, static_cast<int>(i) + 1, values[i]) != SQLITE_OK) return fail(error());
  }
  std::vector<SqlRow> rows;
  int step = sqlite3_step(raw);
  for (; step == SQLITE_ROW; step = sqlite3_step(raw)) rows.push_back(row(raw));
  if (step != SQLITE_DONE) return fail(error());
  return rows;
}

Result<int> Database::change(std::string_view sql, const std::vector<SqlValue>& values) {
  if (const auto done = query(sql, values); !done) return fail(done.error());
  return sqlite3_changes(handle_.get());
}

std::int64_t Database::last_id() const {
  return sqlite3_last_insert_rowid(handle_.get());
}

Error Database::error() const {
  return {ErrorCode::kUnavailable,
          fmt::format("database {}: {}", path_.string(),
                      handle_ ? sqlite3_errmsg(handle_.get()) : "out of memory")};
}

Result<Database::Transaction> Database::Transaction::begin(Database& database) {
  if (const auto ok = database.change("BEGIN IMMEDIATE"); !ok) return fail(ok.error());
  return Transaction(database);
}

Database::Transaction::~Transaction() {
  if (database_ == nullptr) return;
  const auto ignored = database_->change("ROLLBACK");
  static_cast<void>(ignored);
}

Result<void> Database::Transaction::commit() {
  SLIPSTICK_CHECK(database_ != nullptr);
  if (const auto ok = database_->change("COMMIT"); !ok) return fail(ok.error());
  database_ = nullptr;
  return {};
}

}  // namespace slipstick
