#pragma once

#include <functional>
#include <vector>

#include "core/base/vec.h"
#include "sim/planner.h"

namespace slipstick {

/// A straight bead of plastic with round ends.
struct ExtrudedSegment {
  Vec2 a;
  Vec2 b;
  double width = 0;   ///< mm.
  double height = 0;  ///< mm: of its layer.
  double z = 0;       ///< mm: its top, where the nozzle was.
};

/// Moves of the machine -> beads, as they are made; nothing is kept but the heights of layers.
///
/// A move that pushes filament while it goes across the bed leaves a bead whose cross-section holds
/// that filament. The layer below is the highest one, of those printed since the nozzle was last
/// lower, whose z is less; the first layer lies on the bed at 0. A bead below 0 is none.
class Deposit {
 public:
  using Sink = std::function<void(const ExtrudedSegment&)>;
  static constexpr double kSameZ = 1e-4;  ///< mm: heights closer than this are one layer.

  /// \pre `filament_diameter` > 0.
  Deposit(double filament_diameter, Sink sink);

  void add(const ExecutedMove& move);

 private:
  void enter_layer(double z);

  double filament_area_;
  Sink sink_;
  std::vector<double> tops_;  ///< Rising; the last one is the layer being printed.
  double height_ = 0;
};

}  // namespace slipstick
