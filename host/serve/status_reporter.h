#pragma once

#include <chrono>
#include <string>

#include "drivers/marlin/sender_events.h"
#include "host/print_control.h"
#include "host/serve/event_log.h"
#include "host/serve/printer_status.h"
#include "host/serve/time_left.h"

namespace slipstick {

/// Keeps the status board and the event log up to date during prints. What changes many times a
/// second is told four times a second.
///
/// Threads: the printing one.
class StatusReporter {
 public:
  StatusReporter(StatusBoard& board, EventLog& events) : board_(board), events_(events) {}

  void job_began(std::int64_t id, const std::string& file);
  void job_is_of(int layers) { status_.layers = layers; }
  void layer_began(PrintedLayer layer);
  void completion(double share) { status_.completion = share; }
  /// After each turn of the printing loop.
  void turn(PrintControl::Wish wish, const StreamFigures& figures);
  void heard(const SenderEvent& event);
  /// Just before `job_ended`. \param state by its name.
  void job_came_to(std::int64_t id, std::string_view state, const std::string& message);
  /// Says what the job came to; the printer is idle, or stopped for somebody to look at.
  void job_ended(PrinterActivity activity, const std::string& message);
  void bed(bool occupied);
  /// Between prints. \param message why not, or empty.
  void connected(bool now, const std::string& message);

 private:
  void set(PrinterActivity activity);
  void keep_time(PrintControl::Wish wish);
  void tell(const char* type);
  [[nodiscard]] static bool due(std::chrono::steady_clock::time_point& last);

  StatusBoard& board_;
  EventLog& events_;
  PrinterStatus status_;
  std::shared_ptr<const PrintedLayer> layer_;
  TimeLeft time_left_;
  std::chrono::steady_clock::time_point began_{};
  std::chrono::steady_clock::time_point progress_told_{};
  std::chrono::steady_clock::time_point temperatures_told_{};
};

}  // namespace slipstick
