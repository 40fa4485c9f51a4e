#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/machine.h"

namespace slipstick {

/// How hot and how fast a machine was over time: equal spans of time from power on, at most
/// `kSamplesMax` of them. When there would be more, spans become twice as long and pairs of samples
/// one; memory does not grow with the print.
class Curves {
 public:
  static constexpr std::size_t kSamplesMax = 1024;

  struct Sample {
    double nozzle = Heater::kRoomCelsius;  ///< °C, as last seen in the span.
    double nozzle_target = 0;
    double bed = Heater::kRoomCelsius;
    double bed_target = 0;
    double way = 0;        ///< mm travelled in the span.
    double speed_max = 0;  ///< mm/s: of the fastest of its moves, each taken as even.
  };

  /// The machine is so at `now`. \pre `now` never goes back.
  void see(Moment now, const Machine& machine);
  /// The machine has made `move`. \pre It ended by the `now` that is seen next.
  void add(const ExecutedMove& move);

  /// Seconds that a sample stands for.
  [[nodiscard]] double span_seconds() const { return span_seconds_; }
  [[nodiscard]] std::span<const Sample> samples() const { return samples_; }

 private:
  /// The sample of that moment; those before it that were not seen are as the last one that was.
  Sample& at(double seconds);
  void halve();

  double span_seconds_ = 1;
  std::vector<Sample> samples_;
};

}  // namespace slipstick
