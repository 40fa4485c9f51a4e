#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include "core/base/vec.h"
#include "sim/bed_leveling.h"
#include "sim/features.h"
#include "sim/heater.h"
#include "sim/job_timer.h"
#include "sim/planner.h"
#include "sim/sd_card.h"

namespace slipstick {

/// What a printer is built of.
struct MachineOptions {
  Vec3 build_volume{220, 220,
                    250};  ///< Soft endstops are 0 and these; of a delta see kinematics.h.
  Kinematics kinematics = {};
  MotionLimits limits = {};  ///< When it is switched on.
  HeaterOptions nozzle = nozzle_options();
  double sensor_noise = 0;  ///< °C that readings are off at most.
  std::uint64_t seed = 1;   ///< Of that.
  Features features = {};
};

/// `machine` with the limits that its kinematics need: the towers of a delta are alike, each as X.
[[nodiscard]] inline MachineOptions built(MachineOptions machine) {
  if (!machine.kinematics.homes_all()) return machine;
  MotionLimits& limits = machine.limits;
  limits.steps_per_mm.z = limits.steps_per_mm.x;
  limits.speed_max.z = limits.speed_max.x;
  limits.acceleration_max.z = limits.acceleration_max.x;
  if (limits.jerk) limits.jerk->z = limits.jerk->x;
  return machine;
}

/// `heater` with a sensor as noisy as `machine` has them.
[[nodiscard]] inline HeaterOptions noisy(HeaterOptions heater, const MachineOptions& machine) {
  heater.noise = machine.sensor_noise;
  heater.seed = machine.seed;
  return heater;
}

/// Everything of the printer that commands change, and how it stands when it is switched on.
struct Machine {
  /// Whether there is filament: without, the motor turns and nothing comes.
  struct Spool {
    bool empty = false;
  };

  Machine(const MachineOptions& built, const Planner::Sink& sink,
          std::shared_ptr<Spool> loaded = std::make_shared<Spool>())
      : options(built),
        limits(built.limits),
        spool(std::move(loaded)),
        planner(through(spool, sink), built.kinematics),
        move_sink(sink),
        nozzle(noisy(built.nozzle, built)),
        bed(noisy(bed_options(), built)) {}

  MachineOptions options;
  MotionLimits limits;
  std::shared_ptr<Spool> spool;  ///< Shared with the sink, which looks at it.
  Planner planner;
  Planner::Sink move_sink;
  Heater nozzle;
  Heater bed;
  int fan = 0;  ///< 0 to 255.
  SdCard card;
  std::optional<MotionLimits> stored;  ///< In the EEPROM.
  BedLeveling leveling;
  JobTimer job;

  Axes position;         ///< Where the last command said to go, in its own coordinates.
  Axes shift;            ///< What G92 made of them: X, Y, Z of the machine less those of commands.
  double filament = 0;   ///< E of the machine: all that was to be pushed, mm.
  double feedrate = 25;  ///< mm/s; Marlin starts with F1500.
  double feedrate_percent = 100;
  double flow_percent = 100;
  bool relative = false;      ///< G91
  bool relative_e = false;    ///< M83
  bool homed = false;         ///< Soft endstops act from then on,
  bool soft_endstops = true;  ///< unless M211 S0 turned them off.
  double extrude_celsius_min = 170;
  bool watches_filament = true;      ///< M412 S, of a machine with a sensor.
  bool host_handles_runout = false;  ///< M412 H.
  bool halted = false;               ///< After kill(): only a reset helps.

  void advance(Moment now) {
    nozzle.set_draught(fan / 255.0);
    nozzle.advance(now);
    bed.advance(now);
    if (!halted) planner.advance(now);
  }

  /// The same while the firmware stands: moves are made, heaters are not controlled.
  void coast(Moment now) {
    nozzle.coast(now);
    bed.coast(now);
    if (!halted) planner.advance(now);
  }

  /// kill(): power off, silence.
  void halt() {
    nozzle.shut_off();
    bed.shut_off();
    fan = 0;
    halted = true;
  }

  /// The reset button: all as at power on but the heat that is there.
  void reset() {
    const Heater was_nozzle = nozzle;
    const Heater was_bed = bed;
    const SdCard was_card = card;
    const auto was_stored = stored;
    *this = Machine(options, move_sink, spool);
    card = was_card;
    card.reset();
    stored = was_stored;
    if (stored) limits = *stored;
    nozzle = was_nozzle;
    bed = was_bed;
    nozzle.shut_off();
    bed.shut_off();
  }

 private:
  [[nodiscard]] static Planner::Sink through(const std::shared_ptr<Spool>& spool,
                                             const Planner::Sink& sink) {
    if (!sink) return {};
    return [spool, sink](const ExecutedMove& move) {
      ExecutedMove made = move;
      if (spool->empty) made.to.e = std::min(made.to.e, made.from.e);
      sink(made);
    };
  }
};

}  // namespace slipstick
