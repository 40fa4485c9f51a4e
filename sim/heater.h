#pragma once

#include <cstdint>
#include <optional>

#include "core/base/rng.h"
#include "drivers/clock.h"

namespace slipstick {

/// What may be broken of a heater.
enum class HeaterDefect : std::uint8_t {
  kNone,
  kSensorOpen,     ///< The cable of the thermistor is cut: it reads -15 °C.
  kSensorShorted,  ///< It reads more than any heater can reach.
  kCold,           ///< No power reaches it, whatever the firmware gives.
  kStuck,          ///< It has full power, whatever the firmware gives.
};

/// What a heater is made of and how the firmware drives it.
struct HeaterOptions {
  enum class Control : std::uint8_t { kPid, kBangBang };

  double rise_max = 380;      ///< °C above the room that full power holds.
  double time_constant = 95;  ///< Seconds in which a difference falls to 1/e.
  double target_max = 260;    ///< °C: higher targets are cut down to it.
  Control control = Control::kPid;
  double fan_loss = 0;     ///< A fan at full speed takes off so much more heat, as a share.
  double noise = 0;        ///< °C that a reading is off at most.
  std::uint64_t seed = 1;  ///< Of that.
};

/// The hot end and the bed as measured on Marlin's own simulated board: 4 °C/s and 1.3 °C/s when
/// cold, 190 °C held with about half the power.
[[nodiscard]] HeaterOptions nozzle_options();
[[nodiscard]] HeaterOptions bed_options();

/// A heated thing of one heat capacity, losing heat to the room in proportion to how much hotter it
/// is.
class Heater {
 public:
  static constexpr double kRoomCelsius = 22;
  static constexpr Moment kControlPeriod{164'000};     ///< Marlin's PID_dT.
  static constexpr Moment kBedCheckPeriod{5'000'000};  ///< Its BED_CHECK_INTERVAL.
  static constexpr double kPidRange = 10;      ///< °C around the target; beyond it all or nothing.
  static constexpr int kPowerMax = 127;        ///< As "@:127" reports it.
  static constexpr double kOpenCelsius = -15;  ///< Read of a sensor that is not there,
  static constexpr double kShortCelsius = 400;  ///< or whose wires touch.

  explicit Heater(const HeaterOptions& options) : options_(options), rng_(options.seed) {}

  /// How fast the fan beside it turns, 0 to 1.
  void set_draught(double share) { draught_ = share; }
  /// 0 is off.
  void set_target(double celsius);
  [[nodiscard]] double target() const { return target_; }

  /// Lets time pass; never back.
  void advance(Moment to);
  /// The same while the firmware stands: the power stays what it is.
  void coast(Moment to);
  /// What the thermistor reads.
  [[nodiscard]] double celsius() const;
  /// How hot it is.
  [[nodiscard]] double true_celsius() const { return celsius_; }
  /// From now on this is broken, and nothing else.
  void suffer(HeaterDefect defect) { defect_ = defect; }
  [[nodiscard]] bool whole() const { return defect_ == HeaterDefect::kNone; }
  /// 0 to `kPowerMax`.
  [[nodiscard]] int power() const;
  /// Whether it has no target. Its power may last until the next step of the control.
  [[nodiscard]] bool off() const { return target_ <= 0; }
  /// Target and power to zero at once.
  void shut_off();

 private:
  void control();
  void read_sensor();
  [[nodiscard]] double pid();

  void warm(Moment to);
  /// Of full power: what reaches it.
  [[nodiscard]] double true_share() const;

  HeaterOptions options_;
  HeaterDefect defect_ = HeaterDefect::kNone;
  Rng rng_;
  double celsius_ = kRoomCelsius;
  double off_by_ = 0;  ///< The sensor, °C.
  double draught_ = 0;
  double target_ = 0;
  double share_ = 0;  ///< Of full power.
  double integral_ = 0;
  double derivative_ = 0;
  double last_celsius_ = kRoomCelsius;
  Moment now_{0};
  Moment next_control_{0};
};

/// Whether a temperature has settled: within 1 °C first, then ten seconds never off by more than 3
/// °C.
class Residency {
 public:
  static constexpr double kWindow = 1;
  static constexpr double kHysteresis = 3;
  static constexpr Moment kDuration{10'000'000};

  /// Takes what is measured at `now`.
  void see(double celsius, double target, Moment now);
  [[nodiscard]] bool settled(Moment now) const { return since_ && now >= *since_ + kDuration; }
  /// Whole seconds left; nothing before the window was reached.
  [[nodiscard]] std::optional<std::int64_t> seconds_left(Moment now) const;

 private:
  std::optional<Moment> since_;
};

}  // namespace slipstick
