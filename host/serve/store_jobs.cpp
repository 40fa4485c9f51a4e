// Store: the queue, the history and the printer.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "host/serve/store.h"

namespace slipstick {
namespace {

constexpr std::array<std::string_view, 6> kStateNames{"queued", "printing",  "done",
                                                      "failed", "cancelled", "interrupted"};

const std::string kJobColumns =
    "SELECT jobs.id, jobs.file, files.name, files.extension, jobs.spec, jobs.state, jobs.created, "
    "jobs.started, jobs.ended, jobs.message, jobs.result, jobs.changes, jobs.pauses "
    "FROM jobs JOIN files ON files.id = jobs.file ";

// The schema knows no other states.
JobState state_of(std::string_view name) {
  const auto at = std::find(kStateNames.begin(), kStateNames.end(), name);
  SLIPSTICK_CHECK(at != kStateNames.end());
  return static_cast<JobState>(at - kStateNames.begin());
}

StoredJob job_of(const SqlRow& row) {
  return {row.integer(0),        row.integer(1), row.text(2),    row.text(3),    row.text(4),
          state_of(row.text(5)), row.integer(6), row.integer(7), row.integer(8), row.text(9),
          row.text(10),          row.text(11),   row.text(12)};
}

Result<std::optional<StoredJob>> first_job(const Result<std::vector<SqlRow>>& rows) {
  if (!rows) return fail(rows.error());
  if (rows->empty()) return std::optional<StoredJob>();
  return job_of(rows->front());
}

std::string text(JobState state) {
  return std::string(name_of(state));
}

}  // namespace

std::string_view name_of(JobState state) {
  return kStateNames[static_cast<std::size_t>(state)];
}

Result<int> Store::queued() {
  const auto rows = database_.query("SELECT count(*) FROM jobs WHERE state = 'queued'");
  if (!rows) return fail(rows.error());
  return static_cast<int>((*rows)[0].integer(0));
}

Result<StoredJob> Store::add_job(const StoredFile& file, std::string_view spec, std::int64_t now) {
  auto transaction = Database::Transaction::begin(database_);
  if (!transaction) return fail(transaction.error());
  const auto waiting = queued();
  if (!waiting) return fail(waiting.error());
  if (*waiting >= kQueueMax) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("the queue has {} jobs and takes no more", kQueueMax));
  }
  const auto added = database_.change(
      "INSERT INTO jobs (file, spec, place, state, created) SELECT id, ?2, "
      "(SELECT coalesce(max(place), 0) + 1 FROM jobs), 'queued', ?3 FROM files "
      "WHERE id = ?1 AND current = 1",
      {file.id, std::string(spec), now});
  if (!added) return fail(added.error());
  if (*added == 0) return fail(ErrorCode::kInput, fmt::format("{} was removed", file.name));
  const std::int64_t id = database_.last_id();
  if (const auto ok = transaction->commit(); !ok) return fail(ok.error());
  const auto stored = job(id);
  if (!stored) return fail(stored.error());
  SLIPSTICK_CHECK(stored->has_value());
  return **stored;
}

Result<std::vector<StoredJob>> Store::jobs(int most) {
  const auto rows =
      database_.query(kJobColumns + "ORDER BY jobs.id DESC LIMIT ?1", {std::int64_t{most}});
  if (!rows) return fail(rows.error());
  std::vector<StoredJob> jobs;
  for (const SqlRow& row : *rows) jobs.push_back(job_of(row));
  return jobs;
}

Result<std::optional<StoredJob>> Store::job(std::int64_t id) {
  return first_job(database_.query(kJobColumns + "WHERE jobs.id = ?1", {id}));
}

Result<std::optional<StoredJob>> Store::next_job() {
  return first_job(
      database_.query(kJobColumns + "WHERE jobs.state = 'queued' ORDER BY jobs.place LIMIT 1"));
}

Result<bool> Store::set_spec(std::int64_t id, std::string_view spec) {
  const auto changed = database_.change(
      "UPDATE jobs SET spec = ?2 WHERE id = ?1 AND state = 'queued'", {id, std::string(spec)});
  if (!changed) return fail(changed.error());
  return *changed == 1;
}

Result<void> Store::set_changes(std::int64_t id, std::string_view changes) {
  const auto changed =
      database_.change("UPDATE jobs SET changes = ?2 WHERE id = ?1", {id, std::string(changes)});
  if (!changed) return fail(changed.error());
  return {};
}

Result<bool> Store::set_pauses(std::int64_t id, std::string_view pauses) {
  const auto changed = database_.change(
      "UPDATE jobs SET pauses = ?2 WHERE id = ?1 AND state NOT IN ('done', 'cancelled')",
      {id, std::string(pauses)});
  if (!changed) return fail(changed.error());
  return *changed == 1;
}

Result<bool> Store::put_first(std::int64_t id) {
  const auto changed = database_.change(
      "UPDATE jobs SET place = (SELECT min(place) - 1 FROM jobs) WHERE id = ?1 AND state = "
      "'queued'",
      {id});
  if (!changed) return fail(changed.error());
  return *changed == 1;
}

Result<bool> Store::claim_job(std::int64_t id, std::int64_t now) {
  auto transaction = Database::Transaction::begin(database_);
  if (!transaction) return fail(transaction.error());
  const auto claimed = database_.change(
      "UPDATE jobs SET state = 'printing', started = ?2 WHERE id = ?1 AND state = 'queued'",
      {id, now});
  if (!claimed) return fail(claimed.error());
  if (*claimed == 0) return false;
  const auto occupied = database_.change("UPDATE printer SET bed_occupied = 1");
  if (!occupied) return fail(occupied.error());
  if (const auto ok = transaction->commit(); !ok) return fail(ok.error());
  return true;
}

Result<bool> Store::claim_again(std::int64_t id) {
  const auto claimed = database_.change(
      "UPDATE jobs SET state = 'printing', ended = 0, message = '' WHERE id = ?1 "
      "AND state IN ('interrupted', 'failed') AND started = (SELECT max(started) FROM jobs) "
      "AND (SELECT bed_occupied FROM printer) = 1",
      {id});
  if (!claimed) return fail(claimed.error());
  return *claimed == 1;
}

Result<bool> Store::cancel_queued(std::int64_t id, std::int64_t now) {
  const auto changed = database_.change(
      "UPDATE jobs SET state = 'cancelled', ended = ?2, message = 'cancelled before it began' "
      "WHERE id = ?1 AND state = 'queued'",
      {id, now});
  if (!changed) return fail(changed.error());
  return *changed == 1;
}

Result<void> Store::end_job(std::int64_t id, const Ending& ending, std::int64_t now) {
  const auto changed = database_.change(
      "UPDATE jobs SET state = ?2, message = ?3, result = ?4, ended = ?5 "
      "WHERE id = ?1 AND state = 'printing'",
      {id, text(ending.state), ending.message, ending.result, now});
  if (!changed) return fail(changed.error());
  std::error_code ignored;
  if (ending.state == JobState::kDone) std::filesystem::remove(journal_of(id), ignored);
  return forget_old_jobs();
}

Result<void> Store::forget_old_jobs() {
  const auto changed = database_.change(
      "DELETE FROM jobs WHERE id IN (SELECT id FROM jobs WHERE state NOT IN ('queued', 'printing') "
      "ORDER BY id DESC LIMIT -1 OFFSET ?1)",
      {std::int64_t{kHistoryMax}});
  if (!changed) return fail(changed.error());
  const auto files =
      database_.change("DELETE FROM files WHERE current = 0 AND id NOT IN (SELECT file FROM jobs)");
  if (!files) return fail(files.error());
  return {};
}

Result<bool> Store::print_is_cut_off() {
  const auto rows = database_.query(
      "SELECT id FROM jobs WHERE state IN ('interrupted', 'failed') "
      "AND started = (SELECT max(started) FROM jobs) "
      "AND (SELECT bed_occupied FROM printer) = 1");
  if (!rows) return fail(rows.error());
  return std::ranges::any_of(*rows, [this](const auto& row) {
    return std::filesystem::exists(journal_of(row.integer(0)));
  });
}

Result<bool> Store::bed_occupied() {
  const auto rows = database_.query("SELECT bed_occupied FROM printer");
  if (!rows) return fail(rows.error());
  return (*rows)[0].integer(0) != 0;
}

Result<std::string> Store::selected() {
  const auto rows = database_.query("SELECT selected FROM printer");
  if (!rows) return fail(rows.error());
  return (*rows)[0].text(0);
}

Result<void> Store::select(std::string_view name) {
  const auto changed = database_.change("UPDATE printer SET selected = ?1", {std::string(name)});
  if (!changed) return fail(changed.error());
  return {};
}

Result<PrinterChoice> Store::printer_instead_of(const PrinterChoice& words) {
  const auto rows = database_.query(
      "SELECT port, machine FROM printer_choice WHERE over_port = ?1 AND over_machine = ?2",
      {words.port, words.machine});
  if (!rows) return fail(rows.error());
  return rows->empty() ? words : PrinterChoice{(*rows)[0].text(0), (*rows)[0].text(1)};
}

Result<void> Store::choose_printer(const PrinterChoice& choice, const PrinterChoice& words) {
  const auto changed =
      database_.change("INSERT OR REPLACE INTO printer_choice VALUES (1, ?1, ?2, ?3, ?4)",
                       {choice.port, choice.machine, words.port, words.machine});
  if (!changed) return fail(changed.error());
  return {};
}

}  // namespace slipstick
