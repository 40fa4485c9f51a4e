#pragma once

#include <filesystem>

#include "drivers/clock.h"
#include "drivers/marlin/sender_events.h"
#include "drivers/unique_fd.h"
#include "host/print_journal.h"

namespace slipstick {

/// Writes down, while a print goes on, what is needed to take it up again.
///
/// What a number on the wire means is written before it is sent, and synced to the disk if it means
/// no line of the job; how far the print is, once a second. So whatever ends the program, the
/// number that the board has taken last tells the line of the job; if the power goes, what is known
/// of the print is older by no more than `kTakenInterval` and `kSyncInterval`.
///
/// A journal that cannot be written is removed, with a warning: the print is worth more.
///
/// Threads: the printing one.
class Journal {
 public:
  static constexpr Moment kTakenInterval = std::chrono::seconds(1);
  static constexpr Moment kSyncInterval = std::chrono::seconds(5);

  /// Begins one: it appears under its name whole, or not at all.
  /// \return kInput if there is a file that is no journal, or that of an unfinished print;
  ///   kUnavailable if it cannot be written.
  [[nodiscard]] static Result<Journal> create(const std::filesystem::path& path,
                                              const JournalHeader& header);

  /// Goes on with one. \param content what was read from it.
  /// \param line where the print goes on: so many lines of the job were sent before.
  [[nodiscard]] static Result<Journal> go_on(const std::filesystem::path& path,
                                             const JournalContent& content, std::uint64_t line);

  /// Before the bytes go out that the event is about.
  void heard(const SenderEvent& event);
  void began(const LayerMark& mark);
  /// Before `began` of the first layer that has it.
  void changed(const SettingsChange& change);
  void turn(const SenderCounters& counters, Moment now);
  void ended(JournalEnd end);

  /// For last words; -1 if it was given up.
  [[nodiscard]] int descriptor() const { return file_.get(); }

 private:
  Journal(std::filesystem::path path, UniqueFd file, std::uint64_t line)
      : path_(std::move(path)), file_(std::move(file)), base_(line), taken_(line) {}

  void write(std::string_view record);
  void sync();
  void give_up(int error);

  std::filesystem::path path_;
  UniqueFd file_;
  std::uint64_t base_;   ///< Lines of the job before those that the sender counts.
  std::uint64_t taken_;  ///< As last written.
  Moment taken_at_{};
  Moment synced_at_{};
};

/// What `path` holds. The message of an error names it.
[[nodiscard]] Result<JournalContent> read_journal(const std::filesystem::path& path);

}  // namespace slipstick
