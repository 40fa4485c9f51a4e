#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/heater.h"

namespace slipstick {

/// Why a firmware does not trust a heater any more.
enum class ThermalAlarm : std::uint8_t { kMinTemp, kMaxTemp, kHeatingFailed, kRunaway };

/// When a heater counts as broken: Marlin's default configuration, as its simulated board has it.
struct ThermalLimits {
  std::string_view name;          ///< As "Heater_ID:" tells it.
  double celsius_min = 5;         ///< While it has a target, no less.
  double celsius_max = 275;       ///< At all times, no more.
  Moment watch{40'000'000};       ///< While heating up, in so long
  double watch_rise = 2;          ///< it must have risen by so much.
  Moment runaway{40'000'000};     ///< Once hot, it may be so long
  double runaway_hysteresis = 4;  ///< below its target by so much.
};

[[nodiscard]] ThermalLimits nozzle_limits();
[[nodiscard]] ThermalLimits bed_limits();

/// Marlin's thermal protection of one heater: what its sensor reads against the limits. Memory of
/// the firmware: a reset forgets it.
class ThermalGuard {
 public:
  explicit ThermalGuard(const ThermalLimits& limits) : limits_(limits) {}

  /// Looks at `heater`. \pre `now` never goes back.
  [[nodiscard]] std::optional<ThermalAlarm> check(const Heater& heater, Moment now);

  /// Whether it has nothing to watch: the heater was off when it looked last.
  [[nodiscard]] bool rests() const { return target_ <= 0; }

  [[nodiscard]] std::string_view name() const { return limits_.name; }

 private:
  void begin(const Heater& heater, Moment now);
  void watch_from(double celsius, Moment now);
  [[nodiscard]] bool failed_to_rise(double celsius, Moment now);
  [[nodiscard]] bool has_run_away(double celsius, Moment now);

  ThermalLimits limits_;
  double target_ = 0;
  bool reached_ = false;           ///< Whether it was as hot as the target.
  std::optional<Moment> rise_by_;  ///< When it must have risen,
  double rise_to_ = 0;             ///< to this.
  Moment below_since_{0};          ///< Or since when it was last hot enough.
};

/// What Marlin says of it before it halts, whole lines.
[[nodiscard]] std::string alarm_text(ThermalAlarm alarm, std::string_view heater);

}  // namespace slipstick
