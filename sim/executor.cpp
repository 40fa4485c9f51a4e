#include "sim/executor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "sim/limit_commands.h"
#include "sim/reports.h"
#include "sim/service_commands.h"

namespace slipstick {

namespace {

Moment moment_of_seconds(double seconds) {
  constexpr double kLongest = 24 * 3600;
  return Moment(static_cast<Moment::rep>(std::clamp(seconds, 0.0, kLongest) * 1e6));
}

}  // namespace

void Executor::begin(std::string_view line, const std::optional<GcodeCommand>& command,
                     Moment now) {
  SLIPSTICK_CHECK(!running());
  wants_ok_ = true;
  if (!command) return unknown(line);
  if (command->letter() == 'T') {
    if (command->code() != 0) {
      text_ += fmt::format("echo:T{} Invalid extruder\n", command->code());
    }
    return;
  }
  if (command->letter() == 'G') {
    if (!run_g(*command, now)) unknown(line);
  } else if (const auto limits = run_limit_command(*command, machine_)) {
    text_ += *limits;
  } else if (const auto answer = run_service_command(*command, machine_, now)) {
    text_ += *answer;
  } else if (!run_motion(*command, now) && !run_heat(*command, now) && !run_talk(*command) &&
             !run_pause(*command)) {
    unknown(line);
  }
}

void Executor::unknown(std::string_view line) {
  text_.append("echo:Unknown command: \"").append(bare_command(line)).append("\"\n");
}

std::string Executor::take_text() {
  return std::exchange(text_, {});
}

bool Executor::run_g(const GcodeCommand& command, Moment now) {
  switch (command.code()) {
    case 0:
    case 1:
      move(command);
      return true;
    case 2:
    case 3:
      arc(command);
      return true;
    case 4:
      dwell(command);
      return true;
    case 21:
      return true;
    case 28:
      home(command);
      return true;
    case 90:
    case 91:  // Both speak for E too, whatever M82 or M83 said before.
      machine_.relative = machine_.relative_e = command.code() == 91;
      return true;
    case 29:
      if (!machine_.options.features.has(Feature::kBedLeveling)) return false;
      probe_bed();
      return true;
    case 92:
      rename_position(command, now);
      return true;
    default:
      return false;
  }
}

bool Executor::run_motion(const GcodeCommand& command, Moment now) {
  switch (command.code()) {
    case 17:
      return true;
    case 18:
    case 84:
    case 400:
      become_still(Stage::kDone);
      return true;
    case 82:
    case 83:
      machine_.relative_e = command.code() == 83;
      return true;
    case 410:
      wait_ = kQuickStopTime;
      become_still(Stage::kDwell);
      return true;
    case 114:
      text_ += position_report(machine_, now);
      return true;
    case 900:
      if (!machine_.options.features.has(Feature::kLinearAdvance)) return false;
      set_advance(command);
      return true;
    default:
      return false;
  }
}

bool Executor::run_heat(const GcodeCommand& command, Moment now) {
  switch (command.code()) {
    case 104:
      if (const auto s = command.value('S')) machine_.nozzle.set_target(*s);
      check_job(false, now);
      return true;
    case 140:
      if (const auto s = command.value('S')) machine_.bed.set_target(*s);
      check_job(false, now);
      return true;
    case 109:
      wait_for_heater(command, machine_.nozzle, now);
      check_job(true, now);
      return true;
    case 190:
      wait_for_heater(command, machine_.bed, now);
      check_job(true, now);
      return true;
    case 105:
      wants_ok_ = false;
      if (const double tool = command.value('T').value_or(0); tool != 0) {
        text_ += fmt::format("echo:M105 Invalid extruder {:.0f}\n", tool);
      } else {
        text_ += "ok" + temperature_text(machine_) + "\n";
      }
      return true;
    case 106:
      machine_.fan = static_cast<int>(std::clamp(command.value('S').value_or(255), 0.0, 255.0));
      return true;
    case 107:
      machine_.fan = 0;
      return true;
    case 108:
      return true;
    case 154:
      if (!machine_.options.features.has(Feature::kPositionReports)) return false;
      if (const auto s = command.value('S')) {
        position_period_ = moment_of_seconds(std::clamp(std::floor(*s), 0.0, 60.0));
      }
      return true;
    case 155:
      if (const auto s = command.value('S')) {
        report_period_ = moment_of_seconds(std::clamp(std::floor(*s), 0.0, 60.0));
      }
      return true;
    default:
      return false;
  }
}

/// PRINTJOB_TIMER_AUTOSTART: a wait for heat begins a job, no heat any more ends it.
void Executor::check_job(bool may_start, Moment now) {
  constexpr double kColdNozzle = 85;  // half of the least that extrudes
  constexpr double kColdBed = 5;
  const bool hot = machine_.nozzle.target() > kColdNozzle || machine_.bed.target() > kColdBed;
  if (hot && may_start) machine_.job.start(now);
  if (!hot) machine_.job.stop(now);
}

bool Executor::run_pause(const GcodeCommand& command) {
  if (!machine_.options.features.has(Feature::kFilamentChange)) return false;
  switch (command.code()) {
    case 0:
    case 1:
      stop_for_user(command);
      return true;
    case 600:
      change_filament();
      return true;
    case 876:  // In its turn: nobody waits for it any more.
      return true;
    default:
      return false;
  }
}

bool Executor::run_talk(const GcodeCommand& command) {
  switch (command.code()) {
    case 113:
      if (const auto s = command.value('S')) {
        busy_period_ = moment_of_seconds(std::clamp(std::floor(*s), 0.0, 60.0));
      } else {
        text_ += fmt::format("echo:M113 S{}\n", busy_period_ / Moment(1'000'000));
      }
      return true;
    case 117:
      return true;
    case 118:
      speak(command.text());
      return true;
    default:
      return false;
  }
}

void Executor::dwell(const GcodeCommand& command) {
  wait_ = Moment(0);
  if (const auto p = command.value('P')) wait_ = moment_of_seconds(*p / 1000);
  if (const auto s = command.value('S')) wait_ = moment_of_seconds(*s);
  become_still(Stage::kDwell);
}

void Executor::wait_for_heater(const GcodeCommand& command, Heater& heater, Moment now) {
  const auto heat = command.value('S');
  const auto both_ways = command.value('R');
  if (!heat && !both_ways) return;
  if (heat && heater.celsius() >= *heat) return heater.set_target(*heat);
  heat_to(heater, heat ? *heat : *both_ways, now);
}

void Executor::heat_to(Heater& heater, double celsius, Moment now) {
  heater.set_target(celsius);
  heater_ = &heater;
  residency_ = {};
  heat_cancelled_ = false;
  until_ = polled_at_ = now;
  stage_ = Stage::kHeat;
}

void Executor::speak(std::string_view words) {
  bool echo = false;
  bool action = false;
  while (words.size() >= 2 && (words[0] == 'E' || words[0] == 'A' || words[0] == 'P') &&
         words[1] >= '0' && words[1] <= '9') {
    echo = echo || (words[0] == 'E' && words[1] == '1');
    action = action || (words[0] == 'A' && words[1] == '1');
    words.remove_prefix(2);
    words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
  }
  if (echo) text_ += "echo:";
  if (action) text_ += "//";
  text_.append(words).append("\r\n");
}

void Executor::become_still(Stage next) {
  after_still_ = next;
  stage_ = Stage::kStill;
}

void Executor::stop_waiting() {
  heat_cancelled_ = stage_ == Stage::kHeat;
  answered_ = stage_ == Stage::kUser;
}

bool Executor::proceed_room(Moment now) {
  while (!machine_.planner.full()) {
    machine_.planner.add(target_, speed_, machine_.limits, now);
    if (head_for_next_piece()) continue;
    stage_ = Stage::kDone;
    return true;
  }
  return false;
}

bool Executor::proceed_still(Moment now) {
  if (!machine_.planner.idle()) return false;
  stage_ = after_still_;
  until_ = now + wait_;
  if (stage_ == Stage::kDone) machine_.planner.rest();
  return stage_ == Stage::kDone;
}

bool Executor::proceed_heat(Moment now) {
  if (heat_cancelled_) return true;
  polled_at_ = now;
  if (now >= until_) {
    const auto left = residency_.seconds_left(now);
    text_ += temperature_text(machine_) + (left ? fmt::format(" W:{}\n", *left) : " W:?\n");
    until_ += kReportPeriod;
  }
  residency_.see(heater_->celsius(), heater_->target(), now);
  return residency_.settled(now);
}

bool Executor::proceed(Moment now) {
  while (proceed_stage(now)) {
    if (next_.empty()) return true;
    const Next next = std::move(next_.front());
    next_.pop_front();
    next(now);
  }
  return false;
}

bool Executor::proceed_stage(Moment now) {
  if (stage_ == Stage::kDone) return true;
  if (stage_ == Stage::kRoom) return proceed_room(now);
  if (stage_ == Stage::kStill && (proceed_still(now) || stage_ == Stage::kStill)) {
    return stage_ == Stage::kDone;
  }
  if (stage_ == Stage::kHeat && !proceed_heat(now)) return false;
  if ((stage_ == Stage::kDwell || stage_ == Stage::kHome) && now < until_) return false;
  if (stage_ == Stage::kUser && !answered_ && !(user_until_ && now >= *user_until_)) return false;
  if (stage_ == Stage::kHome) finish_homing(now);
  machine_.planner.rest();
  stage_ = Stage::kDone;
  return true;
}

std::optional<Moment> Executor::wakes_at() const {
  switch (stage_) {
    case Stage::kDwell:
    case Stage::kHome:
      return until_;
    case Stage::kUser:
      return user_until_;
    case Stage::kHeat:
      return std::min(until_, polled_at_ + kHeatPoll);
    case Stage::kDone:
    case Stage::kRoom:
    case Stage::kStill:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace slipstick
