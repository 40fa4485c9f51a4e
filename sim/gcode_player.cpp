#include "sim/gcode_player.h"

#include <algorithm>

#include "core/gcode/parse.h"
#include "sim/reports.h"

namespace slipstick {

namespace {

// What the firmware owns or only a host needs: nothing is printed by it.
bool is_talk(const GcodeCommand& command) {
  return command.is('M', 110) || command.is('M', 115) || command.is('M', 108);
}

std::string_view complaint_in(std::string_view text) {
  if (text.starts_with("echo:Unknown command")) return "unknown command";
  if (text.find(kColdExtrusion) != std::string_view::npos) return "cold extrusion prevented";
  if (text.find(kLongExtrusion) != std::string_view::npos) return "too long extrusion prevented";
  if (text.find(kBadArc) != std::string_view::npos) return "arc without a centre or end";
  if (text.find("Invalid extruder") != std::string_view::npos) return "invalid extruder";
  return {};
}

}  // namespace

GcodePlayer::GcodePlayer(const MachineOptions& machine, const Planner::Sink& sink)
    : machine_(machine, sink), executor_(machine_) {}

void GcodePlayer::play(std::string_view line) {
  ++number_;
  if (machine_.halted || bare_command(line).empty()) return;
  const auto command = parse_gcode(line);
  if (command && command->is('M', 112)) return machine_.halt();
  if (command && is_talk(*command)) return;
  executor_.begin(line, command, now_);
  run_down_command(line);
  if (const auto why = complaint_in(executor_.take_text()); !why.empty()) refuse(line, why);
}

void GcodePlayer::run_down_command(std::string_view line) {
  const Moment deadline = now_ + kPatience;
  while (executor_.running() && !executor_.proceed(now_)) {
    if (now_ < deadline) {
      pass_time(deadline);
    } else {
      executor_.stop_waiting();
      refuse(line, "waited for a day");
      pass_time(deadline + kPatience);
    }
  }
}

void GcodePlayer::pass_time(Moment deadline) {
  Moment next = deadline;
  if (const auto at = executor_.running() ? executor_.wakes_at() : std::nullopt) {
    next = std::min(next, *at);
  }
  if (const auto at = machine_.planner.next_event()) next = std::min(next, *at);
  now_ = std::max(next, now_ + Moment(1));
  machine_.advance(now_);
  if (watcher_) watcher_(now_, machine_);
}

double GcodePlayer::finish() {
  while (!machine_.halted && !machine_.planner.idle()) pass_time(now_ + kPatience);
  return std::chrono::duration<double>(now_).count();
}

void GcodePlayer::refuse(std::string_view line, std::string_view why) {
  ++refused_;
  if (refusals_.size() == kRefusalsListed) return;
  refusals_.push_back({number_, std::string(bare_command(line)), std::string(why)});
}

}  // namespace slipstick
