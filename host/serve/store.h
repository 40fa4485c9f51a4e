#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/serve/database.h"
#include "host/serve/file_names.h"
#include "host/serve/printer_choice.h"

namespace slipstick {

struct StoredFile {
  std::int64_t id = 0;
  std::string name;
  std::string extension;
  std::int64_t size = 0;
  std::int64_t created = 0;  ///< Seconds since 1970.
};

enum class JobState : std::uint8_t {
  kQueued,
  kPrinting,
  kDone,
  kFailed,
  kCancelled,
  kInterrupted,  ///< The daemon ended in the middle.
};
[[nodiscard]] std::string_view name_of(JobState state);

struct StoredJob {
  std::int64_t id = 0;
  std::int64_t file = 0;
  std::string file_name;
  std::string extension;
  std::string spec;  ///< JSON: job_spec.h.
  JobState state = JobState::kQueued;
  std::int64_t created = 0;
  std::int64_t started = 0;  ///< 0: not yet; likewise `ended`.
  std::int64_t ended = 0;
  std::string message;  ///< Why it is not done.
  std::string result;   ///< JSON, or empty: what was printed.
  std::string changes;  ///< settings_changes_text.h, or empty: settings changed in the print.
  std::string pauses;   ///< JSON: the layers before which the print is paused, in order.
};

/// Files and jobs, in a folder of their own: what was accepted survives the end of the process and
/// of the machine at any moment.
///
///     slipstick.db          the database; its schema is in store.cpp
///     files/17.stl          the bytes of file 17; a file, once stored, never changes
///     pictures/17.png       a small picture of file 17, once somebody has asked for it
///     journals/5.journal    what is needed to take up the print of job 5, until the bed is clear
///     incoming/             uploads under way; emptied at the start
///
/// A job goes from queued to printing by one committed change, and never back: nothing is printed
/// twice. What was cut off goes on where it was, if somebody asks for it. Errors of the disk are
/// kUnavailable.
///
/// Threads: one; another thread opens its own.
class Store {
 public:
  static constexpr int kFilesMax = 10'000;
  static constexpr int kQueueMax = 1'000;
  static constexpr int kHistoryMax = 10'000;  ///< Jobs that are over, oldest forgotten.

  /// \param now seconds since 1970, wherever one is asked for.
  [[nodiscard]] static Result<Store> open(const std::filesystem::path& folder);

  /// After a start, before anything else: jobs that were being printed become interrupted, what no
  /// row speaks of is removed. \return how many were interrupted.
  [[nodiscard]] Result<int> recover(std::int64_t now);

  /// A path for bytes that are not a file yet.
  [[nodiscard]] std::filesystem::path incoming(std::string_view name) const;
  [[nodiscard]] std::filesystem::path path_of(std::int64_t file, std::string_view extension) const;
  /// Where the picture of a file is kept, if there is one. It goes with the file.
  [[nodiscard]] std::filesystem::path picture_of(std::int64_t file) const;

  /// Takes over the bytes in `from`, which are on the disk. A file of that name is replaced; jobs
  /// that want it keep the old one. \return kUnavailable also if there are too many.
  [[nodiscard]] Result<StoredFile> add_file(const FileName& name, const std::filesystem::path& from,
                                            std::int64_t now);
  [[nodiscard]] Result<std::vector<StoredFile>> files();
  [[nodiscard]] Result<std::optional<StoredFile>> file(std::string_view name);
  /// The bytes stay while a job wants them. \return whether there was one.
  [[nodiscard]] Result<bool> remove_file(std::string_view name);

  /// At the end of the queue. \return kUnavailable also if that is full.
  [[nodiscard]] Result<StoredJob> add_job(const StoredFile& file, std::string_view spec,
                                          std::int64_t now);
  /// How many wait.
  [[nodiscard]] Result<int> queued();
  /// How a queued job is to be printed. \return whether it was queued.
  [[nodiscard]] Result<bool> set_spec(std::int64_t id, std::string_view spec);
  /// What was changed in the print of the job.
  [[nodiscard]] Result<void> set_changes(std::int64_t id, std::string_view changes);
  /// Before which layers the print of the job is paused, unless it is over. \return whether it was
  /// not.
  [[nodiscard]] Result<bool> set_pauses(std::int64_t id, std::string_view pauses);
  /// Puts a queued job before all others. \return whether it was queued.
  [[nodiscard]] Result<bool> put_first(std::int64_t id);
  /// The newest first.
  [[nodiscard]] Result<std::vector<StoredJob>> jobs(int most);
  [[nodiscard]] Result<std::optional<StoredJob>> job(std::int64_t id);
  /// The first in the queue.
  [[nodiscard]] Result<std::optional<StoredJob>> next_job();

  /// Queued to printing; the bed is occupied from then on. \return whether it was queued.
  [[nodiscard]] Result<bool> claim_job(std::int64_t id, std::int64_t now);
  /// Interrupted or failed to printing again, if it was the last to be printed and the bed was not
  /// cleared. \return whether it was.
  [[nodiscard]] Result<bool> claim_again(std::int64_t id);
  [[nodiscard]] std::filesystem::path journal_of(std::int64_t job) const;
  /// Whether there is what is needed to take the print of `job` up.
  [[nodiscard]] bool can_be_taken_up(const StoredJob& job) const;
  /// Queued to cancelled. \return whether it was queued.
  [[nodiscard]] Result<bool> cancel_queued(std::int64_t id, std::int64_t now);
  struct Ending {
    JobState state = JobState::kDone;
    std::string message;
    std::string result;
  };
  /// Printing to what it came to. The journal of a job that is done is removed.
  [[nodiscard]] Result<void> end_job(std::int64_t id, const Ending& ending, std::int64_t now);

  /// Whether the last print was interrupted or failed, and may still be taken up: its printer may
  /// count the print's lines yet.
  [[nodiscard]] Result<bool> print_is_cut_off();
  /// Whether something lies on the bed that somebody must take off before the next print.
  [[nodiscard]] Result<bool> bed_occupied();
  /// No print can be taken up after that.
  [[nodiscard]] Result<void> clear_bed();

  /// The name of the file that clients which first select and then start have selected, or empty.
  [[nodiscard]] Result<std::string> selected();
  [[nodiscard]] Result<void> select(std::string_view name);

  /// What was chosen instead of `words`, those of the command line; else these. Other words than
  /// those of that time are newer than the choice.
  [[nodiscard]] Result<PrinterChoice> printer_instead_of(const PrinterChoice& words);
  [[nodiscard]] Result<void> choose_printer(const PrinterChoice& choice,
                                            const PrinterChoice& words);

 private:
  Store(std::filesystem::path folder, Database database)
      : folder_(std::move(folder)), database_(std::move(database)) {}
  [[nodiscard]] Result<void> migrate();
  [[nodiscard]] Result<void> sweep();
  /// Removes the bytes of a file that is no longer listed, unless a job wants them; what stays, the
  /// next start removes.
  void discard(const StoredFile& file);
  [[nodiscard]] Result<void> forget_old_jobs();

  std::filesystem::path folder_;
  Database database_;
};

}  // namespace slipstick
