#include "sim/firmware.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/gcode/parse.h"
#include "sim/reports.h"

namespace slipstick {

Firmware::Firmware(Machine& machine, Moment power_on)
    : machine_(machine), executor_(machine), boot_at_(power_on + kBootTime) {}

std::string Firmware::take_text() {
  return std::exchange(text_, {});
}

bool Firmware::step(Moment now) {
  if (machine_.halted) return false;
  if (!booted_) return boot(now);
  if (resending_) {
    request_resend();
    return true;
  }
  return stay_busy(now) || report(now) || read_lines() || run_command(now);
}

bool Firmware::boot(Moment now) {
  if (now < boot_at_) return false;
  text_ += banner_report(machine_);
  booted_ = true;
  return true;
}

bool Firmware::read_lines() {
  if (ring_.empty() || !reads()) return false;
  while (reads() && !resending_) {
    const auto byte = ring_.pop();
    if (!byte) break;
    if (const auto line = reader_.feed(*byte)) receive(*line);
  }
  return true;
}

void Firmware::receive(std::string_view line) {
  const Verdict verdict = gate_.judge(line);
  if (verdict == Verdict::kDuplicate) return;
  if (verdict != Verdict::kAccepted) return reject(verdict);
  obey_early(line);
  if (machine_.halted) return;
  queue_.emplace_back(line);
  ++lines_accepted_;
}

void Firmware::reject(Verdict verdict) {
  text_ += fmt::format("Error:{}{}\n", error_text(verdict), gate_.last_number());
  resending_ = true;
}

void Firmware::request_resend() {
  ring_.clear();
  text_ += fmt::format("Resend: {}\n", gate_.last_number() + 1).append(kOk);
  resending_ = false;
  ++resends_requested_;
}

void Firmware::obey_early(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  if (line.starts_with("M108")) executor_.stop_waiting();
  if (line.starts_with("M112")) kill();
}

void Firmware::kill() {
  text_ += kKilled;
  machine_.halt();
}

bool Firmware::stay_busy(Moment now) {
  if (!executor_.running() || executor_.busy_period() <= Moment(0) || now < busy_at_) return false;
  text_ += kBusy;
  busy_at_ = now + executor_.busy_period();
  return true;
}

bool Firmware::report(Moment now) {
  if (executor_.report_period() != report_period_) {
    report_period_ = executor_.report_period();
    report_at_ = now + report_period_;
  }
  if (report_period_ <= Moment(0) || now < report_at_) return false;
  text_ += temperature_text(machine_) + "\n";
  report_at_ = now + report_period_;
  return true;
}

void Firmware::begin_command(Moment now) {
  busy_at_ = now + executor_.busy_period();
  ok_due_ = true;
  const auto command = parse_gcode(queue_.front());
  if (command && command->is('M', 112)) return kill();
  if (command && command->is('M', 110)) {
    constexpr double kMost = std::numeric_limits<std::int32_t>::max();
    if (const auto n = command->value('N')) {
      gate_.set_last_number(static_cast<std::int64_t>(std::clamp(*n, -kMost, kMost)));
    }
    return;
  }
  executor_.begin(queue_.front(), command, now);
  ok_due_ = executor_.wants_ok();
}

bool Firmware::run_command(Moment now) {
  if (queue_.empty()) return false;
  const bool fresh = !executor_.running();
  if (fresh) begin_command(now);
  if (machine_.halted) return true;

  const bool returned = !executor_.running() || executor_.proceed(now);
  const std::string printed = executor_.take_text();
  text_ += printed;
  if (!returned) return fresh || !printed.empty();
  if (ok_due_) text_ += kOk;
  queue_.pop_front();
  return true;
}

bool Firmware::has_work() const {
  return resending_ || (reads() && !ring_.empty()) || (!queue_.empty() && !executor_.running());
}

std::optional<Moment> Firmware::wakes_at(Moment now) const {
  if (machine_.halted) return std::nullopt;
  if (!booted_) return boot_at_;
  if (has_work()) return now;
  std::optional<Moment> first;
  const auto consider = [&first](Moment m) { first = first ? std::min(*first, m) : m; };
  if (report_period_ > Moment(0)) consider(report_at_);
  if (!executor_.running()) return first;
  if (executor_.busy_period() > Moment(0)) consider(busy_at_);
  if (const auto m = executor_.wakes_at()) consider(*m);
  return first;
}

}  // namespace slipstick
