#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/marlin_model_voyage.h"

namespace slipstick {

/// What befalls a print besides a bad cable, once it has executed `after` lines of its job.
struct Mishap {
  enum class Kind : std::uint8_t {
    kNone,
    kHeardReset,    ///< The board resets and says so.
    kUnheardReset,  ///< The same, and its words are lost.
    kThermalFault,
    kFreeze,       ///< The board neither hears nor speaks any more.
    kShortUnplug,  ///< The cable is out for some seconds, the board stays on.
    kUnplug,       ///< The cable is out for good.
    kMute,         ///< The board hears, but no word of it comes through any more.
    kCancel,       ///< The user cancels.
    kEmergency,    ///< The user stops the printer at once.
  };
  Kind kind = Kind::kNone;
  std::size_t after = 0;
  Moment lasts{};  ///< Of kShortUnplug.
};

/// A whole print, drawn from one number.
struct VoyagePlan {
  std::vector<std::string> job;
  Voyage::Options options;
  Mishap mishap;
};

inline std::vector<std::string> draw_job(Rng& rng) {
  std::vector<std::string> job{"M140 S60", "M104 S200", "G28", "M83"};
  const std::size_t lines = 30 + rng.below(90);
  // Relative extrusions, where a line executed twice would matter; homing and a wait now and then.
  while (job.size() < lines) {
    const std::size_t i = job.size();
    job.push_back(rng.below(60) == 0
                      ? fmt::format("G4 P{}", i)
                      : fmt::format("G1 X{}.{} Y{} E.0{}", i % 200, i % 10, i * 7 % 180, i));
  }
  return job;
}

inline WireFaults draw_wire(Rng& rng) {
  WireFaults faults;
  if (rng.below(4) != 0) faults.damage = 2e-2 * rng.unit() * rng.unit();
  faults.latency = std::chrono::microseconds(100 + rng.below(rng.below(8) == 0 ? 300'000 : 3'000));
  if (rng.below(3) == 0) faults.jitter = std::chrono::microseconds(rng.below(50'000));
  if (rng.below(4) == 0) faults.stalls = 0.01 * rng.unit();
  return faults;
}

inline VoyagePlan draw_plan(std::uint64_t seed) {
  Rng rng(seed);
  VoyagePlan plan;
  plan.job = draw_job(rng);
  plan.options.printer.swallows_duplicates = rng.below(3) != 0;
  plan.options.printer.ok_after_resend = rng.below(4) != 0;
  plan.options.printer.undetected = Undetected::kObeyGhosts;
  plan.options.down = draw_wire(rng);
  plan.options.up = draw_wire(rng);
  if (rng.below(2) == 0) plan.options.up.lost_oks = 0.02;
  if (rng.below(2) == 0) plan.options.up.doubled_oks = 0.02;
  constexpr std::uint64_t kKinds = 10;
  if (rng.below(2) == 0) plan.mishap.kind = static_cast<Mishap::Kind>(rng.below(kKinds));
  plan.mishap.after = rng.below(plan.job.size());
  plan.mishap.lasts = std::chrono::milliseconds(rng.below(30'000));
  return plan;
}

/// Sails by a plan.
class PlannedVoyage {
 public:
  PlannedVoyage(const VoyagePlan& plan, std::uint64_t seed)
      : plan_(plan), voyage_(plan.options, seed) {}

  SenderState run() {
    const SenderState end = voyage_.print(plan_.job, [this] { meanwhile(); });
    until_end_ = voyage_.printer().executed().size();
    voyage_.come_to_rest();
    return end;
  }

  Voyage& voyage() { return voyage_; }
  /// Of the job. After its end the wire may still make an odd heater command of the safe end, which
  /// is given ten times for that reason; moves it may not.
  std::vector<std::string> executed() {
    std::vector<std::string> lines = voyage_.printer().executed();
    const auto end = lines.begin() + static_cast<std::ptrdiff_t>(until_end_);
    const auto of_safe_end = [](const std::string& line) { return line.starts_with('M'); };
    lines.erase(std::remove_if(end, lines.end(), of_safe_end), lines.end());
    return job_lines(lines);
  }

  /// Whether nothing stands in the way of the whole print.
  bool can_finish() const {
    using enum Mishap::Kind;
    return !happened_ || plan_.mishap.kind == kNone || plan_.mishap.kind == kShortUnplug;
  }

 private:
  void meanwhile() {
    if (replug_at_ && voyage_.now() >= *replug_at_) {
      voyage_.unplug(false);
      replug_at_.reset();
    }
    if (happened_ || plan_.mishap.kind == Mishap::Kind::kNone) return;
    if (voyage_.sender().state() == SenderState::kGreeting) return;
    if (voyage_.printer().executed().size() < plan_.mishap.after) return;
    happened_ = true;
    befall(plan_.mishap.kind);
  }

  void befall(Mishap::Kind kind) {
    using enum Mishap::Kind;
    const bool resets = kind == kHeardReset || kind == kUnheardReset;
    if (resets) voyage_.printer().reset(voyage_.now());
    if (kind == kUnheardReset) voyage_.lose_replies();
    if (kind == kThermalFault) {
      voyage_.printer().kill(voyage_.now(),
                             "Error:MAXTEMP triggered, system stopped! Heater_ID: E0\n");
    }
    if (kind == kFreeze) voyage_.printer().halt();
    if (kind == kShortUnplug || kind == kUnplug) voyage_.unplug(true);
    if (kind == kMute) voyage_.mute();
    if (kind == kShortUnplug) replug_at_ = voyage_.now() + plan_.mishap.lasts;
    if (kind == kCancel) voyage_.sender().stop();
    if (kind == kEmergency) voyage_.sender().emergency_stop();
  }

  const VoyagePlan& plan_;
  Voyage voyage_;
  std::optional<Moment> replug_at_;
  std::size_t until_end_ = 0;
  bool happened_ = false;
};

}  // namespace slipstick
