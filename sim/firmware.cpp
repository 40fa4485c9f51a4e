#include "sim/firmware.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/gcode/parse.h"
#include "sim/host_talk.h"
#include "sim/reports.h"

namespace slipstick {

namespace {

/// What runs when the sensor finds no filament, before the next command of the queue.
constexpr std::string_view kRunoutScript = "M600";

/// "echo:busy: paused for user"
std::string busy_for_user(std::string_view busy) {
  return std::string(busy.substr(0, busy.find("processing"))) + "paused for user\n";
}

std::string repetier_error(Verdict verdict, const LineGate& gate) {
  if (verdict == Verdict::kWrongChecksum) return "Error:Wrong checksum\n";
  if (verdict == Verdict::kNoChecksum) return "Error:Missing checksum\n";
  return fmt::format("Error:expected line {} got {}\n", gate.last_number() + 1, gate.seen_number());
}

}  // namespace

Firmware::Firmware(Machine& machine, const Personality& personality, Moment power_on,
                   ResetCause cause)
    : machine_(machine),
      personality_(personality),
      executor_(machine),
      reader_(personality.line_max),
      gate_(personality.lines),
      boot_at_(power_on + kBootTime),
      cause_(cause) {}

std::string Firmware::take_text() {
  return std::exchange(text_, {});
}

bool Firmware::step(Moment now) {
  if (machine_.halted) return false;
  if (!booted_) return boot(now);
  if (!work(now)) return idle(now);
  wait_at_ = now + personality_.wait_period;
  return true;
}

void Firmware::notice(char byte) {
  if (!machine_.options.features.has(Feature::kEmergencyParser)) return;
  if (const auto found = emergency_parser_.feed(byte)) emergency_ = found;
}

bool Firmware::obey_emergency(Moment now) {
  const auto emergency = std::exchange(emergency_, std::nullopt);
  if (!emergency) return false;
  switch (emergency->kind) {
    case Emergency::Kind::kKill:
      kill(personality_.shutdown);
      break;
    case Emergency::Kind::kQuickStop:
      executor_.quick_stop(now);
      break;
    case Emergency::Kind::kContinue:
    case Emergency::Kind::kAnswer:
      executor_.stop_waiting();
      break;
  }
  return true;
}

bool Firmware::watch_filament() {
  if (!machine_.options.features.has(Feature::kFilamentSensor)) return false;
  if (!machine_.spool->empty) ran_out_ = false;
  const bool printing = machine_.filament > 0 && !machine_.nozzle.off();
  if (ran_out_ || !machine_.spool->empty || !machine_.watches_filament || !printing) return false;
  ran_out_ = true;
  const bool changes =
      !machine_.host_handles_runout && machine_.options.features.has(Feature::kFilamentChange);
  if (executor_.talks_to_host()) {
    text_ += action_line("filament_runout T0") +
             action_line(changes ? "paused filament_runout 0" : "pause filament_runout 0");
  }
  if (changes) {
    queue_.insert(queue_.begin() + (executor_.running() ? 1 : 0),
                  {std::string(kRunoutScript), true});
  }
  return true;
}

bool Firmware::work(Moment now) {
  if (obey_emergency(now)) return true;
  if (resending_) {
    request_resend();
    return true;
  }
  return guard(now) || watch_filament() || stay_busy(now) || report(now) || read_lines(now) ||
         run_command(now);
}

bool Firmware::boot(Moment now) {
  if (now < boot_at_) return false;
  text_ += banner_report(personality_, machine_, cause_);
  if (executor_.talks_to_host()) text_ += action_line("prompt_end");
  wait_at_ = now + personality_.wait_period;
  booted_ = true;
  return true;
}

bool Firmware::read_lines(Moment now) {
  if (ring_.empty() || !reads()) return false;
  while (reads() && !resending_) {
    const auto byte = ring_.pop();
    if (!byte) break;
    if (!machine_.options.features.has(Feature::kMeatPack)) {
      if (const auto line = reader_.feed(*byte)) receive(*line, now);
      continue;
    }
    for (const char c : meat_pack_.feed(*byte)) {
      if (const auto line = reader_.feed(c)) receive(*line, now);
    }
    text_ += meat_pack_.take_text();
  }
  return true;
}

void Firmware::receive(std::string_view line, Moment now) {
  const Verdict verdict = gate_.judge(line);
  if (verdict == Verdict::kDropped) return;
  if (verdict == Verdict::kSkipped) {
    text_ += fmt::format("skip {}\n", gate_.seen_number()).append(kOk);
    return;
  }
  if (verdict != Verdict::kAccepted) return reject(verdict);
  obey_early(line, now);
  if (machine_.halted) return;
  if (personality_.ok == OkTime::kWhenReceived) text_ += kOk;
  queue_.push_back({std::string(line)});
  ++lines_accepted_;
}

void Firmware::reject(Verdict verdict) {
  if (personality_.complaint == Complaint::kMarlin) {
    text_ += fmt::format("Error:{}{}\n", error_text(verdict), gate_.last_number());
  } else if (personality_.complaint == Complaint::kRepetier) {
    text_ += repetier_error(verdict, gate_);
  }
  // Marlin 1.0 finds fault with a lone checksum but does not ask again.
  const bool asks =
      verdict != Verdict::kNoNumber || personality_.lines.numbers != NumberCheck::kAnyN;
  resending_ = asks;
}

void Firmware::request_resend() {
  ring_.clear();
  text_ += fmt::format("{}{}\n", personality_.resend, gate_.last_number() + 1)
               .append(personality_.resend_tail == kOk ? ok() : personality_.resend_tail);
  resending_ = false;
  ++resends_requested_;
}

void Firmware::obey_early(std::string_view line, Moment now) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  if (machine_.options.features.has(Feature::kEmergencyParser)) return;
  const auto matches = [&](std::string_view code) {
    if (personality_.early == EarlyStop::kPrefix) return line.starts_with(code);
    return (personality_.early == EarlyStop::kExact ? line : bare_command(line)) == code;
  };
  if (matches("M108")) executor_.stop_waiting();
  if (matches("M410")) executor_.quick_stop(now);
  if (matches("M112")) kill(personality_.shutdown);
}

void Firmware::kill(std::string_view reason) {
  text_.append(reason).append(personality_.killed);
  if (executor_.talks_to_host()) text_ += action_line("poweroff");
  machine_.halt();
}

bool Firmware::has_to_guard() const {
  const auto is_safe = [](const Heater& heater, const ThermalGuard& guard) {
    return heater.off() && heater.whole() && guard.rests();
  };
  return !is_safe(machine_.nozzle, nozzle_guard_) || !is_safe(machine_.bed, bed_guard_);
}

bool Firmware::guard(Moment now) {
  if (!has_to_guard() || now < guard_at_) return false;
  guard_at_ = now + kGuardPeriod;
  const auto is_broken = [&](ThermalGuard& guard, const Heater& heater) {
    const auto alarm = guard.check(heater, now);
    if (alarm) kill(alarm_text(*alarm, guard.name()));
    return alarm.has_value();
  };
  return is_broken(nozzle_guard_, machine_.nozzle) || is_broken(bed_guard_, machine_.bed);
}

bool Firmware::idle(Moment now) {
  if (personality_.wait_period <= Moment(0) || !queue_.empty() || now < wait_at_) return false;
  text_ += "wait\n";
  wait_at_ = now + personality_.wait_period;
  return true;
}

bool Firmware::stay_busy(Moment now) {
  if (!executor_.running() || personality_.busy.empty()) return false;
  if (executor_.busy_period() <= Moment(0) || now < busy_at_) return false;
  text_ += executor_.waits_for_user() ? busy_for_user(personality_.busy)
                                      : std::string(personality_.busy);
  busy_at_ = now + executor_.busy_period();
  return true;
}

bool Firmware::report(Moment now) {
  const bool temperatures = temperatures_.due(executor_.report_period(), now);
  const bool positions = positions_.due(executor_.position_period(), now);
  if (temperatures) text_ += temperature_text(machine_) + "\n";
  if (positions) text_ += position_report(machine_, now);
  return temperatures || positions;
}

std::string Firmware::ok() const {
  if (!machine_.options.features.has(Feature::kAdvancedOk)) return std::string(kOk);
  const std::string_view line = queue_.empty() ? std::string_view() : queue_.front().line;
  std::string number;
  if (line.starts_with('N')) {
    number = fmt::format(" {}", line.substr(0, line.find_first_not_of("-0123456789", 1)));
  }
  // The command that is acknowledged still takes its place.
  const std::size_t taken = std::min(queue_.size(), personality_.queue_max);
  return fmt::format("ok{} P{} B{}\n", number, Planner::kUsable - machine_.planner.queued(),
                     personality_.queue_max - taken);
}

bool Firmware::read_card() {
  const auto next = machine_.card.next();
  if (!next) return false;
  text_ += next->said;
  if (next->line && !next->line->empty()) queue_.push_back({*next->line, true});
  return true;
}

void Firmware::begin_command(Moment now) {
  busy_at_ = now + executor_.busy_period();
  const bool late_ok = personality_.ok == OkTime::kWhenDone && !queue_.front().own;
  ok_due_ = late_ok;
  const std::string& line = queue_.front().line;
  if (machine_.options.features.has(Feature::kSdCard) && machine_.card.writes(bare_command(line))) {
    return;
  }
  const auto command = parse_gcode(line);
  if (command && command->is('M', 112)) return kill(personality_.shutdown);
  if (command && command->is('M', 110)) {
    constexpr double kMost = std::numeric_limits<std::int32_t>::max();
    if (const auto n = command->value('N')) {
      gate_.set_last_number(static_cast<std::int64_t>(std::clamp(*n, -kMost, kMost)));
    }
    return;
  }
  if (command && command->is('M', 115)) {
    text_ += identity_report(personality_, machine_.options.features);
    ok_due_ = late_ok && !personality_.identity.starts_with("ok");
    return;
  }
  if (command && command->is('M', 999)) return request_resend();
  executor_.begin(line, command, now);
  ok_due_ = late_ok && executor_.wants_ok();
}

bool Firmware::run_command(Moment now) {
  if (queue_.empty()) return read_card();
  const bool fresh = !executor_.running();
  if (fresh) begin_command(now);
  if (machine_.halted) return true;

  const bool returned = !executor_.running() || executor_.proceed(now);
  std::string printed = executor_.take_text();
  // M105's "ok" went out when it was received; its temperatures stand alone.
  if (personality_.ok == OkTime::kWhenReceived && printed.starts_with("ok ")) printed.erase(0, 3);
  text_ += printed;
  if (!returned) return fresh || !printed.empty();
  if (ok_due_) text_ += ok();
  queue_.pop_front();
  return true;
}

bool Firmware::has_work() const {
  return emergency_ || resending_ || (machine_.card.prints() && queue_.empty()) ||
         (reads() && !ring_.empty()) || (!queue_.empty() && !executor_.running());
}

std::optional<Moment> Firmware::wakes_at(Moment now) const {
  if (machine_.halted) return std::nullopt;
  if (!booted_) return boot_at_;
  if (has_work()) return now;
  std::optional<Moment> first;
  const auto consider = [&first](Moment m) { first = first ? std::min(*first, m) : m; };
  if (has_to_guard()) consider(guard_at_);
  if (const auto at = temperatures_.next_at()) consider(*at);
  if (const auto at = positions_.next_at()) consider(*at);
  if (personality_.wait_period > Moment(0) && queue_.empty()) consider(wait_at_);
  if (!executor_.running()) return first;
  if (!personality_.busy.empty() && executor_.busy_period() > Moment(0)) consider(busy_at_);
  if (const auto m = executor_.wakes_at()) consider(*m);
  return first;
}

}  // namespace slipstick
