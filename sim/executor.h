#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/gcode/parse.h"
#include "sim/arc.h"
#include "sim/machine.h"

namespace slipstick {

/// Commands -> machine. One command runs at a time; most end at once, some wait for the planner,
/// the clock or a heater, as their handlers in Marlin do.
///
/// M110, M112 and M115 belong to the firmware (firmware.h), which owns line numbers, life and name.
class Executor {
 public:
  static constexpr Moment kHomingTime{
      15'400'000};  ///< Seen with Marlin 2.1.2 on its simulated board.
  static constexpr Moment kProbingTime{
      31'500'000};  ///< Of nine points, three and a half seconds each.
  static constexpr Moment kQuickStopTime{1'999'000};  ///< M410 keeps the planner empty so long.
  static constexpr Moment kReportPeriod{1'000'000};   ///< Of temperatures during M109 and M190.
  static constexpr Moment kHeatPoll{100'000};
  static constexpr Moment kHeaterTimeout{45'000'000};  ///< Of M600: then the nozzle is cold.
  static constexpr double kExtrusionMax = 200;         ///< mm of filament in one move.
  static constexpr double kFarthest = 1e6;  ///< mm: no coordinate is beyond, homed or not.

  explicit Executor(Machine& machine) : machine_(machine) {}

  /// Starts `command`, which `line` was parsed to. \pre Not running.
  void begin(std::string_view line, const std::optional<GcodeCommand>& command, Moment now);

  /// Goes on with the command. \pre Running. \return Whether it has returned.
  [[nodiscard]] bool proceed(Moment now);

  [[nodiscard]] bool running() const { return stage_ != Stage::kDone || !next_.empty(); }
  /// When `proceed` should be called next if the planner does nothing before; nothing if only the
  /// planner counts. \pre Running.
  [[nodiscard]] std::optional<Moment> wakes_at() const;

  /// Ends a wait for a heater or for somebody: M108. A firmware with a display has no other way to
  /// be told, and here nobody stands at one.
  void stop_waiting();
  [[nodiscard]] bool waits_for_user() const { return stage_ == Stage::kUser; }
  [[nodiscard]] bool talks_to_host() const;

  /// Drops all moves where the machine is now: M410 when it is read. The filament that they would
  /// have pushed is not pushed; E of the commands stays.
  void quick_stop(Moment now);

  /// Whether the command that just returned gets the usual "ok" (M105 brings its own).
  [[nodiscard]] bool wants_ok() const { return wants_ok_; }
  /// What was printed since the last call.
  [[nodiscard]] std::string take_text();

  /// Seconds between reports that M155 asked for; 0 is none.
  [[nodiscard]] Moment report_period() const { return report_period_; }
  /// The same of positions, that M154 asked for.
  [[nodiscard]] Moment position_period() const { return position_period_; }
  /// Seconds between "busy" lines (M113); 0 is none.
  [[nodiscard]] Moment busy_period() const { return busy_period_; }

 private:
  enum class Stage : std::uint8_t { kDone, kRoom, kStill, kDwell, kHome, kHeat, kUser };
  /// What a command does when the stage before is over.
  using Next = std::function<void(Moment now)>;

  // Each says whether the command was one of its own.
  bool run_g(const GcodeCommand& command, Moment now);
  bool run_motion(const GcodeCommand& command, Moment now);
  bool run_heat(const GcodeCommand& command, Moment now);
  bool run_talk(const GcodeCommand& command);
  bool run_pause(const GcodeCommand& command);
  void unknown(std::string_view line);

  void move(const GcodeCommand& command);
  void arc(const GcodeCommand& command);
  void take_feedrate(const GcodeCommand& command);
  /// mm/s that moves are asked for.
  [[nodiscard]] double speed() const;
  /// Plans the way to `to`, in the commands' own coordinates, as soon as there is room.
  void head_for(const Axes& to);
  /// Goes on with the way in pieces. \return Whether there was more of it.
  [[nodiscard]] bool head_for_next_piece();
  void dwell(const GcodeCommand& command);
  void home(const GcodeCommand& command);
  void set_advance(const GcodeCommand& command);
  void finish_homing(Moment now);
  void rename_position(const GcodeCommand& command, Moment now);
  void wait_for_heater(const GcodeCommand& command, Heater& heater, Moment now);
  void check_job(bool may_start, Moment now);
  void probe_bed();
  void heat_to(Heater& heater, double celsius, Moment now);
  void speak(std::string_view words);
  /// Waits until all moves are made, then goes on to `next`.
  void become_still(Stage next);

  /// Where `command` goes, in its own coordinates.
  [[nodiscard]] Axes destination(const GcodeCommand& command) const;
  /// The same place, or the nearest within the soft endstops.
  [[nodiscard]] Axes within_endstops(Axes to) const;
  /// `e` mm of filament, or 0 and a complaint where that is not allowed.
  [[nodiscard]] double allowed_extrusion(double e);
  /// Plans a way of the firmware's own, in coordinates of the machine.
  void plan_to(const Axes& to, double speed);

  void then(Next next);
  void wait_for_user(std::optional<Moment> until);
  void stop_for_user(const GcodeCommand& command);
  void change_filament();
  void ask_for_filament(Moment now);
  void go_back();
  [[nodiscard]] Axes parking_place(double z) const;

  [[nodiscard]] bool proceed_stage(Moment now);
  [[nodiscard]] bool proceed_room(Moment now);
  [[nodiscard]] bool proceed_still(Moment now);
  [[nodiscard]] bool proceed_heat(Moment now);

  Machine& machine_;
  Stage stage_ = Stage::kDone;
  std::string text_;
  bool wants_ok_ = true;

  Axes target_;  ///< Of the move that waits for room.
  double speed_ = 0;
  /// A way in pieces, of which `next` is to be planned.
  struct Way {
    std::function<Axes(int)> end_of;
    int pieces = 0;
    int next = 1;
  };
  std::optional<Way> way_;

  std::deque<Next> next_;
  std::optional<Moment> user_until_;
  bool answered_ = false;  ///< Whether somebody ended the wait, not time.
  Axes parked_from_;       ///< Of the machine.

  Stage after_still_ = Stage::kDone;
  Moment wait_{0};   ///< How long to dwell once still.
  Moment until_{0};  ///< Of dwelling and homing; next report of heating.
  Moment polled_at_{0};
  Heater* heater_ = nullptr;
  Residency residency_;
  bool heat_cancelled_ = false;
  Axes homed_to_;     ///< Where homing will have brought the machine,
  Axes homed_shift_;  ///< and what is then left of G92: that of the other axes.

  Moment report_period_{0};
  Moment position_period_{0};
  Moment busy_period_{2'000'000};
};

}  // namespace slipstick
