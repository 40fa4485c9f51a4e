#include "host/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <variant>

#include "host/atomic_file.h"

namespace slipstick {
namespace {

tl::unexpected<Error> cannot_write(const std::filesystem::path& path) {
  return fail(ErrorCode::kUnavailable, fmt::format("cannot write {}: {}", path.string(),
                                                   std::generic_category().message(errno)));
}

Result<UniqueFd> open_for_more(const std::filesystem::path& path) {
  UniqueFd file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (!file.valid()) return cannot_write(path);
  return file;
}

// A print is not forgotten because the next one uses the same name.
Result<void> check_unused(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return {};
  const auto content = read_journal(path);
  if (!content) return fail(content.error());
  if (content->end == JournalEnd::kFinished) return {};
  return fail(ErrorCode::kInput,
              fmt::format("{} is the journal of a print that was not finished; take it up with "
                          "slipstick print --resume {}, or remove the file",
                          path.string(), path.string()));
}

}  // namespace

Result<JournalContent> read_journal(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  if (!bytes) return fail(bytes.error());
  auto content = parse_journal(*bytes);
  if (!content) return fail(content.error().within(path.string()));
  return content;
}

Result<Journal> Journal::create(const std::filesystem::path& path, const JournalHeader& header) {
  if (const auto ok = check_unused(path); !ok) return fail(ok.error());
  if (const auto ok = write_file(path, header_record(header)); !ok) return fail(ok.error());
  auto file = open_for_more(path);
  if (!file) return fail(file.error());
  return Journal(path, *std::move(file), 0);
}

Result<Journal> Journal::go_on(const std::filesystem::path& path, const JournalContent& content,
                               std::uint64_t line) {
  auto file = open_for_more(path);
  if (!file) return fail(file.error());
  // What was cut off must not be taken for the beginning of the next record.
  if (::ftruncate(file->get(), static_cast<off_t>(content.size)) != 0) return cannot_write(path);
  return Journal(path, *std::move(file), line);
}

void Journal::heard(const SenderEvent& event) {
  if (const auto* session = std::get_if<SessionBegun>(&event)) {
    write(session_record(session->first, base_));
  } else if (const auto* bound = std::get_if<LineBound>(&event)) {
    write(other_record(bound->line, bound->text));
    sync();
  } else if (const auto* inserted = std::get_if<QuestionInserted>(&event)) {
    write(inserted_record(inserted->line));
    sync();
  }
}

void Journal::began(const LayerMark& mark) {
  write(layer_record(mark));
}

void Journal::changed(const SettingsChange& change) {
  write(change_record(change));
  sync();
}

void Journal::turn(const SenderCounters& counters, Moment now) {
  const std::uint64_t taken = base_ + counters.lines_sure;
  if (taken != taken_ && now - taken_at_ >= kTakenInterval) {
    write(taken_record(taken));
    taken_ = taken;
    taken_at_ = now;
  }
  if (now - synced_at_ < kSyncInterval) return;
  synced_at_ = now;
  sync();
}

void Journal::ended(JournalEnd end) {
  write(end_record(end));
  sync();
}

void Journal::write(std::string_view record) {
  if (!file_.valid()) return;
  // One call a record: whoever dies meanwhile leaves whole records, and at most one that is cut.
  const ssize_t written = ::write(file_.get(), record.data(), record.size());
  if (written != static_cast<ssize_t>(record.size())) give_up(written < 0 ? errno : ENOSPC);
}

void Journal::sync() {
  if (file_.valid() && ::fdatasync(file_.get()) != 0) give_up(errno);
}

void Journal::give_up(int error) {
  spdlog::error("{}: {}; this print cannot be taken up again", path_.string(),
                std::generic_category().message(error));
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace slipstick
