// Store: the folder, the schema, and files. What a crash may leave at any point is what `sweep`
// removes: bytes without a row. A row without bytes cannot be: bytes come first and go last.
#include "host/serve/store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <set>
#include <system_error>

#include "drivers/unique_fd.h"

namespace slipstick {
namespace {

namespace fs = std::filesystem;

// Version n of the schema is what the first n make. Never changed, only added to.
constexpr std::array<std::string_view, 10> kMigrations{
    "CREATE TABLE files (id INTEGER PRIMARY KEY AUTOINCREMENT, name TEXT NOT NULL, "
    "extension TEXT NOT NULL, size INTEGER NOT NULL, created INTEGER NOT NULL, "
    "current INTEGER NOT NULL DEFAULT 1) STRICT",
    "CREATE UNIQUE INDEX files_by_name ON files (name) WHERE current = 1",
    "CREATE TABLE jobs (id INTEGER PRIMARY KEY AUTOINCREMENT, "
    "file INTEGER NOT NULL REFERENCES files (id), spec TEXT NOT NULL, "
    "place INTEGER NOT NULL, state TEXT NOT NULL "
    "CHECK (state IN ('queued', 'printing', 'done', 'failed', 'cancelled', 'interrupted')), "
    "created INTEGER NOT NULL, started INTEGER NOT NULL DEFAULT 0, "
    "ended INTEGER NOT NULL DEFAULT 0, message TEXT NOT NULL DEFAULT '', "
    "result TEXT NOT NULL DEFAULT '') STRICT",
    "CREATE TABLE printer (id INTEGER PRIMARY KEY CHECK (id = 1), "
    "bed_occupied INTEGER NOT NULL, selected TEXT NOT NULL) STRICT",
    "ALTER TABLE jobs ADD COLUMN changes TEXT NOT NULL DEFAULT ''",
    // Of accounts.h.
    "CREATE TABLE users (id INTEGER PRIMARY KEY AUTOINCREMENT, "
    "name TEXT NOT NULL UNIQUE COLLATE NOCASE, password TEXT NOT NULL, "
    "created INTEGER NOT NULL) STRICT",
    "CREATE TABLE sessions (id INTEGER PRIMARY KEY AUTOINCREMENT, hash TEXT NOT NULL UNIQUE, "
    "user INTEGER NOT NULL REFERENCES users (id) ON DELETE CASCADE, created INTEGER NOT NULL, "
    "seen INTEGER NOT NULL) STRICT",
    "CREATE TABLE keys (id INTEGER PRIMARY KEY AUTOINCREMENT, hash TEXT NOT NULL UNIQUE, "
    "user INTEGER NOT NULL REFERENCES users (id) ON DELETE CASCADE, name TEXT NOT NULL, "
    "scope TEXT NOT NULL CHECK (scope IN ('read', 'print', 'control', 'admin')), "
    "created INTEGER NOT NULL, used INTEGER NOT NULL DEFAULT 0) STRICT",
    "ALTER TABLE jobs ADD COLUMN pauses TEXT NOT NULL DEFAULT '[]'",
    // What was chosen, instead of which words of the command line.
    "CREATE TABLE printer_choice (id INTEGER PRIMARY KEY CHECK (id = 1), port TEXT NOT NULL, "
    "machine TEXT NOT NULL, over_port TEXT NOT NULL, over_machine TEXT NOT NULL) STRICT"};

// Whose bytes are wanted: what is to be printed, and what was cut off and still lies on the bed.
const std::string kWanted =
    "(SELECT file FROM jobs WHERE state IN ('queued', 'printing') OR "
    "(state IN ('interrupted', 'failed') AND started = (SELECT max(started) FROM jobs) "
    "AND (SELECT bed_occupied FROM printer) = 1))";
const std::string kFileColumns = "SELECT id, name, extension, size, created FROM files ";

StoredFile file_of(const SqlRow& row) {
  return {row.integer(0), row.text(1), row.text(2), row.integer(3), row.integer(4)};
}

Error cannot(std::string_view what, const fs::path& path, int error) {
  return {ErrorCode::kUnavailable, fmt::format("cannot {} {}: {}", what, path.string(),
                                               std::generic_category().message(error))};
}

// A new name is on the disk only once its folder is.
Result<void> sync_folder(const fs::path& folder) {
  const UniqueFd fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() < 0 || ::fsync(fd.get()) != 0) return fail(cannot("write", folder, errno));
  return {};
}

Result<void> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail(cannot("make", folder, error.value()));
  return {};
}

// What cannot be removed is tried again at the next start.
void remove_all_but(const std::set<fs::path>& kept, const fs::path& folder) {
  std::error_code error, ignored;
  std::vector<fs::path> surplus;
  const fs::directory_iterator end;
  for (fs::directory_iterator at(folder, error); !error && at != end; at.increment(error)) {
    if (!kept.contains(at->path())) surplus.push_back(at->path());
  }
  for (const fs::path& path : surplus) fs::remove(path, ignored);
}

}  // namespace

Result<Store> Store::open(const fs::path& folder) {
  for (const fs::path& each :
       {folder, folder / "files", folder / "pictures", folder / "incoming", folder / "journals"}) {
    if (const auto ok = make_folder(each); !ok) return fail(ok.error());
  }
  auto database = Database::open(folder / "slipstick.db");
  if (!database) return fail(database.error());
  Store store(folder, std::move(*database));
  if (const auto ok = store.migrate(); !ok) return fail(ok.error());
  return store;
}

Result<void> Store::migrate() {
  auto transaction = Database::Transaction::begin(database_);
  if (!transaction) return fail(transaction.error());
  const auto version = database_.query("PRAGMA user_version");
  if (!version) return fail(version.error());
  const auto from = static_cast<std::size_t>((*version)[0].integer(0));
  if (from > kMigrations.size()) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("{} was written by a newer slipstick; use that, or another --data",
                            (folder_ / "slipstick.db").string()));
  }
  for (std::size_t i = from; i < kMigrations.size(); ++i) {
    if (const auto ok = database_.change(kMigrations[i]); !ok) return fail(ok.error());
  }
  const auto row = database_.change("INSERT OR IGNORE INTO printer VALUES (1, 0, '')");
  if (!row) return fail(row.error());
  const auto noted = database_.query(fmt::format("PRAGMA user_version = {}", kMigrations.size()));
  if (!noted) return fail(noted.error());
  return transaction->commit();
}

Result<int> Store::recover(std::int64_t now) {
  const auto interrupted = database_.change(
      "UPDATE jobs SET state = 'interrupted', ended = ?1, "
      "message = 'slipstick ended while it was printed' WHERE state = 'printing'",
      {now});
  if (!interrupted) return fail(interrupted.error());
  if (const auto ok = forget_old_jobs(); !ok) return fail(ok.error());
  if (const auto ok = sweep(); !ok) return fail(ok.error());
  return *interrupted;
}

Result<void> Store::sweep() {
  const auto rows =
      database_.query("SELECT id, extension FROM files WHERE current = 1 OR id IN " + kWanted);
  if (!rows) return fail(rows.error());
  std::set<fs::path> kept;
  for (const SqlRow& row : *rows) {
    kept.insert(path_of(row.integer(0), row.text(1)));
    kept.insert(picture_of(row.integer(0)));
  }
  for (const char* name : {"files", "pictures", "incoming"}) remove_all_but(kept, folder_ / name);
  return {};
}

fs::path Store::incoming(std::string_view name) const {
  return folder_ / "incoming" / name;
}

fs::path Store::journal_of(std::int64_t job) const {
  return folder_ / "journals" / fmt::format("{}.journal", job);
}

bool Store::can_be_taken_up(const StoredJob& job) const {
  std::error_code ignored;
  const bool cut_off = job.state == JobState::kInterrupted || job.state == JobState::kFailed;
  return cut_off && fs::exists(journal_of(job.id), ignored);
}

Result<void> Store::clear_bed() {
  const auto changed = database_.change("UPDATE printer SET bed_occupied = 0");
  if (!changed) return fail(changed.error());
  // Only of jobs that are over now: the next one may begin meanwhile.
  const auto over =
      database_.query("SELECT id FROM jobs WHERE state NOT IN ('queued', 'printing')");
  if (!over) return fail(over.error());
  std::error_code ignored;
  for (const SqlRow& job : *over) fs::remove(journal_of(job.integer(0)), ignored);
  return {};
}

fs::path Store::path_of(std::int64_t file, std::string_view extension) const {
  return folder_ / "files" / fmt::format("{}{}", file, extension);
}

fs::path Store::picture_of(std::int64_t file) const {
  return folder_ / "pictures" / fmt::format("{}.png", file);
}

Result<StoredFile> Store::add_file(const FileName& name, const fs::path& from, std::int64_t now) {
  std::error_code error;
  const auto size = fs::file_size(from, error);
  if (error) return fail(cannot("read", from, error.value()));
  const auto old = file(name.text());
  if (!old) return fail(old.error());
  auto transaction = Database::Transaction::begin(database_);
  if (!transaction) return fail(transaction.error());
  const auto count = database_.query("SELECT count(*) FROM files WHERE current = 1");
  if (!count) return fail(count.error());
  if ((*count)[0].integer(0) >= kFilesMax) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("there are {} files and no more are taken; remove some", kFilesMax));
  }
  const auto replaced =
      database_.change("UPDATE files SET current = 0 WHERE name = ?1", {name.text()});
  if (!replaced) return fail(replaced.error());
  const auto added =
      database_.change("INSERT INTO files (name, extension, size, created) VALUES (?1, ?2, ?3, ?4)",
                       {name.text(), name.extension(), static_cast<std::int64_t>(size), now});
  if (!added) return fail(added.error());
  StoredFile stored{database_.last_id(), name.text(), name.extension(),
                    static_cast<std::int64_t>(size), now};
  const fs::path to = path_of(stored.id, stored.extension);
  if (std::rename(from.c_str(), to.c_str()) != 0) return fail(cannot("write", to, errno));
  if (const auto ok = sync_folder(to.parent_path()); !ok) return fail(ok.error());
  if (const auto ok = transaction->commit(); !ok) return fail(ok.error());
  if (*old) discard(**old);
  return stored;
}

Result<std::vector<StoredFile>> Store::files() {
  const auto rows = database_.query(kFileColumns + "WHERE current = 1 ORDER BY name LIMIT ?1",
                                    {std::int64_t{kFilesMax}});
  if (!rows) return fail(rows.error());
  std::vector<StoredFile> files;
  for (const SqlRow& row : *rows) files.push_back(file_of(row));
  return files;
}

Result<std::optional<StoredFile>> Store::file(std::string_view name) {
  const auto rows =
      database_.query(kFileColumns + "WHERE current = 1 AND name = ?1", {std::string(name)});
  if (!rows) return fail(rows.error());
  if (rows->empty()) return std::optional<StoredFile>();
  return file_of(rows->front());
}

Result<bool> Store::remove_file(std::string_view name) {
  const auto there = file(name);
  if (!there) return fail(there.error());
  if (!*there) return false;
  const auto removed =
      database_.change("UPDATE files SET current = 0 WHERE id = ?1", {(*there)->id});
  if (!removed) return fail(removed.error());
  discard(**there);
  return true;
}

void Store::discard(const StoredFile& file) {
  const auto wanting =
      database_.query("SELECT 1 FROM files WHERE id = ?1 AND id IN " + kWanted, {file.id});
  if (!wanting || !wanting->empty()) return;
  std::error_code ignored;
  fs::remove(path_of(file.id, file.extension), ignored);
  fs::remove(picture_of(file.id), ignored);
}

}  // namespace slipstick
