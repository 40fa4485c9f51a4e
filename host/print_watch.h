#pragma once

#include <deque>

#include "host/sliced_layer.h"
#include "sim/deposit.h"
#include "sim/print_judge.h"

namespace slipstick {

/// Watches what the simulated printer lays down and compares it, layer by layer, with the contours
/// that it was to print. Keeps the contours of the layers under way only.
class PrintWatch {
 public:
  PrintWatch(double filament_diameter, double sampling);

  /// A layer is about to be sent.
  void expect(const SlicedLayer& layer);

  /// What the printer's planner reports to.
  [[nodiscard]] Planner::Sink sink();

  /// After the machine has come to rest.
  [[nodiscard]] const PrintVerdict& finish() { return judge_.finish(); }
  [[nodiscard]] const PrintVerdict& verdict() const { return judge_.verdict(); }
  [[nodiscard]] double filament_mm() const { return filament_mm_; }

 private:
  struct Expected {
    double top;
    Contours contours;
  };

  [[nodiscard]] std::optional<Contours> contours_at(double z) const;

  std::deque<Expected> expected_;
  double filament_mm_ = 0;
  PrintJudge judge_;
  Deposit deposit_;
};

}  // namespace slipstick
