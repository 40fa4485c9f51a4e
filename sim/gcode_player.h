#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/executor.h"
#include "sim/machine.h"

namespace slipstick {

/// A line that the machine did not do as it says.
struct Refusal {
  long line = 0;     ///< From 1.
  std::string text;  ///< The command.
  std::string why;   ///< "Unknown command", …
};

/// Runs a program on the machine without a wire: each line is there as soon as the one before it
/// has returned. Virtual time, deterministic.
class GcodePlayer {
 public:
  static constexpr std::size_t kRefusalsListed = 100;
  /// A command that has not returned by then, longer than the longest dwell (a heater that cannot
  /// get so hot) is given up.
  static constexpr Moment kPatience = std::chrono::hours(25);

  GcodePlayer(const MachineOptions& machine, const Planner::Sink& sink);

  /// Gets the machine each time when time has passed.
  using Watcher = std::function<void(Moment now, const Machine&)>;
  void show_to(Watcher watcher) { watcher_ = std::move(watcher); }

  /// Obeys the next line of the program. After M112 nothing is obeyed.
  void play(std::string_view line);

  /// Waits until the machine stands. \return Seconds since it was switched on.
  double finish();

  [[nodiscard]] const MotionStatistics& motion() const { return machine_.planner.statistics(); }
  /// How many lines were refused or not understood, and the first of them.
  [[nodiscard]] std::int64_t refused() const { return refused_; }
  [[nodiscard]] const std::vector<Refusal>& refusals() const { return refusals_; }

 private:
  void run_down_command(std::string_view line);
  void pass_time(Moment deadline);
  void refuse(std::string_view line, std::string_view why);

  Watcher watcher_;
  Machine machine_;
  Executor executor_;
  Moment now_{0};
  long number_ = 0;
  std::int64_t refused_ = 0;
  std::vector<Refusal> refusals_;
};

}  // namespace slipstick
