#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "host/resume_point.h"
#include "host/serve/hook.h"
#include "host/serve/job_spec.h"
#include "host/serve/serial_log.h"
#include "host/serve/status_reporter.h"
#include "host/serve/store.h"

namespace slipstick {

/// The thread of one printer: takes jobs from the store, one at a time, and prints them. The next
/// one waits until the bed is said to be clear.
///
/// Between prints it stays connected, tries again where it cannot, and leaves the printer alone
/// only where a connection would do harm: while a print that was cut off may be taken up, whose
/// lines the board may still count, and after an emergency stop, until something is to be done.
/// A simulated printer is there only while it prints.
///
/// Threads: requests by any thread.
class PrinterWorker {
 public:
  struct Options {
    std::filesystem::path data;
    std::string port;  ///< Of the printer there is at first, as `defaults.printer`.
    JobDefaults defaults;
    std::optional<HookTarget> power_on = {};  ///< Told before a print begins, which waits for it.
  };

  /// Recovers the store and begins. If a print was cut off by the end of an earlier process, the
  /// printer is told to cool down first; its motors keep their power, so that it can be taken up.
  /// \return kUnavailable if the store cannot be opened.
  [[nodiscard]] static Result<std::unique_ptr<PrinterWorker>> start(Options options,
                                                                    StatusBoard& board,
                                                                    EventLog& events);
  /// Ends a print under way with the heaters off, and waits for that.
  ~PrinterWorker();
  PrinterWorker(const PrinterWorker&) = delete;
  PrinterWorker& operator=(const PrinterWorker&) = delete;

  /// The printer that there is, and what jobs are for unless they say otherwise.
  [[nodiscard]] std::string port();
  [[nodiscard]] JobDefaults defaults();
  /// From now on. The printer there was is left with its heaters off. \return kPrinter while a
  /// print is under way. \pre both are known to be good.
  [[nodiscard]] Result<void> use(const PrinterChoice& choice);

  /// Of all that is said to the printer, in prints and between them.
  [[nodiscard]] SerialLog& serial_log() { return *serial_log_; }

  /// Something in the store changed: a job was added, the bed was cleared.
  void wake();

  /// Each returns whether a print was under way (job `id`) to which it applies.
  bool pause();
  bool resume();
  bool cancel(std::int64_t id);
  /// Each of `commands` is said to the printer, before the next line of a print.
  /// \return kInput for what cannot be said: in a print, all that is no `interjection`; else what
  /// has no place in a job. kPrinter if nobody is connected, or too much waits.
  [[nodiscard]] Result<void> say(const std::vector<std::string>& commands);
  /// The settings of the layers of job `id`, a model that is being printed; else nothing. Of a
  /// print that is over meanwhile no layer can be changed any more.
  [[nodiscard]] std::shared_ptr<SettingsTimeline> timeline_of(std::int64_t id);
  /// Goes on with the print of job `id`, which was cut off. \return whether the printer is free.
  bool take_up(std::int64_t id, Consent consent);
  /// Kills the printer, whether it prints or not. \return why it could not be told.
  [[nodiscard]] Result<void> emergency_stop();

 private:
  PrinterWorker(Options options, Store store, StatusBoard& board, EventLog& events);
  void run();
  [[nodiscard]] Result<bool> print_next();
  struct TakingUp {
    std::int64_t job = 0;
    Consent consent = Consent::kNone;
  };
  [[nodiscard]] std::optional<TakingUp> asked_to_take_up();
  [[nodiscard]] Result<bool> print_again(const TakingUp& what);
  void print(const StoredJob& job, std::optional<Consent> take_up);
  [[nodiscard]] Result<void> switch_power_on(const StoredJob& job) const;
  [[nodiscard]] Result<std::shared_ptr<SettingsTimeline>> begin_timeline(const StoredJob& job,
                                                                         const JobSpec& spec);
  [[nodiscard]] Result<std::string> printed(const StoredJob& claimed,
                                            std::optional<Consent> take_up);
  [[nodiscard]] Store::Ending ending(const Result<std::string>& printed);
  [[nodiscard]] std::shared_ptr<PrintControl> begin(std::int64_t id);
  [[nodiscard]] bool pauses_before(std::int64_t job, int layer);
  PrintControl::Wish over();
  [[nodiscard]] std::shared_ptr<PrintControl> current();
  [[nodiscard]] bool wait_for_work();
  [[nodiscard]] bool may_connect();
  [[nodiscard]] Result<void> stay_idle();
  [[nodiscard]] std::shared_ptr<PrintControl> begin_idle();
  [[nodiscard]] bool end_idle();
  void stop_again();
  [[nodiscard]] bool is_called();

  const Options options_;
  const std::shared_ptr<SerialLog> serial_log_;
  Store store_;              ///< The worker's own.
  StatusReporter reporter_;  ///< Likewise.
  bool halted_ = false;      ///< Likewise: the printer has stopped itself between prints.

  std::mutex mutex_;  ///< Protects what follows.
  std::condition_variable changed_;
  std::string port_;
  JobDefaults defaults_;
  std::shared_ptr<PrintControl> control_;       ///< Of the job under way.
  std::shared_ptr<SettingsTimeline> timeline_;  ///< Likewise, if it is a model.
  std::int64_t job_ = 0;
  std::shared_ptr<PrintControl> idle_;  ///< Of the connection between prints.
  bool left_alone_ = false;             ///< After an emergency stop.
  std::optional<TakingUp> take_up_;
  bool look_again_ = true;
  bool stopping_ = false;

  std::thread thread_;  // last: it uses what stands above
};

}  // namespace slipstick
