// Commands that wait for somebody: M0, M1, M600.
#include <algorithm>

#include "sim/executor.h"
#include "sim/host_talk.h"

namespace slipstick {

namespace {

// Marlin's example of a parking place and its speeds, as ADVANCED_PAUSE_FEATURE has them.
constexpr double kParkMargin = 10;  ///< mm from the left and the rear.
constexpr double kParkLift = 20;
constexpr double kParkSpeed = 100;  ///< mm/s.
constexpr double kLiftSpeed = 5;
constexpr double kPauseRetraction = 2;
constexpr double kRetractionSpeed = 60;

constexpr std::string_view kInsert = "echo:Insert filament and send M108\n";
constexpr std::string_view kReheat = "echo:Send M108 to heat nozzle\n";

}  // namespace

bool Executor::talks_to_host() const {
  return machine_.options.features.has(Feature::kHostPrompts);
}

void Executor::then(Next next) {
  next_.push_back(std::move(next));
}

void Executor::wait_for_user(std::optional<Moment> until) {
  stage_ = Stage::kUser;
  user_until_ = until;
  answered_ = false;
}

/// M0 and M1: S seconds or P milliseconds, or until somebody goes on.
void Executor::stop_for_user(const GcodeCommand& command) {
  const double seconds = command.value('S').value_or(command.value('P').value_or(0) / 1000);
  const bool plain = command.text().empty() || command.value('S') || command.value('P');
  const std::string prompt(!plain ? command.text() : command.code() == 0 ? "M0 Stop" : "M1 Stop");
  if (!plain) text_ += "echo:" + prompt + "\n";
  become_still(Stage::kDone);
  then([this, seconds, prompt](Moment now) {
    if (talks_to_host()) text_ += prompt_lines(prompt, {"Continue"});
    const Moment wait(static_cast<Moment::rep>(std::min(seconds, 86'400.0) * 1e6));
    wait_for_user(seconds > 0 ? std::optional(now + wait) : std::nullopt);
  });
}

void Executor::change_filament() {
  become_still(Stage::kDone);
  if (!machine_.homed) {
    then([this](Moment) { home(*parse_gcode("G28")); });
  }
  then([this](Moment) {
    if (talks_to_host()) text_ += action_line("paused");
    parked_from_ = machine_.planner.target();
    parked_from_.e = machine_.filament;
    plan_to({parked_from_.x, parked_from_.y, parked_from_.z, parked_from_.e - kPauseRetraction},
            kRetractionSpeed);
  });
  then([this](Moment) { plan_to(parking_place(parked_from_.z), kLiftSpeed); });
  then([this](Moment) {
    const Box3 reach = machine_.options.kinematics.reach(machine_.options.build_volume);
    Axes there = parking_place(parked_from_.z);
    there.x = machine_.options.kinematics.homes_all() ? 0 : reach.low.x + kParkMargin;
    there.y = reach.high.y - kParkMargin;
    plan_to(there, kParkSpeed);
  });
  then([this](Moment) { become_still(Stage::kDone); });
  then([this](Moment now) { ask_for_filament(now); });
}

Axes Executor::parking_place(double z) const {
  const double top = machine_.options.build_volume.z;
  return {parked_from_.x, parked_from_.y, std::min(z + kParkLift, top),
          parked_from_.e - kPauseRetraction};
}

/// The heater is turned off when nobody comes; then it has to be asked to heat again first.
void Executor::ask_for_filament(Moment now) {
  if (talks_to_host()) text_ += prompt_lines("Nozzle Parked", {"Continue"});
  text_ += kInsert;
  wait_for_user(now + kHeaterTimeout);
  then([this](Moment) {
    if (answered_) return go_back();
    const double target = machine_.nozzle.target();
    machine_.nozzle.set_target(0);
    if (talks_to_host()) text_ += prompt_lines("HeaterTimeout", {"Reheat"});
    text_ += kReheat;
    wait_for_user(std::nullopt);
    then([this, target](Moment at) { heat_to(machine_.nozzle, target, at); });
    then([this](Moment at) { ask_for_filament(at); });
  });
}

/// Whoever went on has put filament in.
void Executor::go_back() {
  machine_.spool->empty = false;
  then([this](Moment) {
    Axes above = parked_from_;
    above.z = parking_place(parked_from_.z).z;
    above.e -= kPauseRetraction;
    plan_to(above, kParkSpeed);
  });
  then([this](Moment) {
    plan_to({parked_from_.x, parked_from_.y, parked_from_.z, parked_from_.e - kPauseRetraction},
            kLiftSpeed);
  });
  then([this](Moment) { plan_to(parked_from_, kRetractionSpeed); });
  then([this](Moment) { become_still(Stage::kDone); });
  then([this](Moment) {
    if (talks_to_host()) text_ += action_line("resumed");
  });
}

}  // namespace slipstick
