#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/box.h"
#include "sim/axes.h"

namespace slipstick {

/// How the motors of a machine move its nozzle: as Marlin 2.1.2 computes it.
///
/// Lengths in mm. What motors do is told as `Axes` too: x, y and z are then its motors A, B and C,
/// e stays e.
class Kinematics {
 public:
  enum class Kind : std::uint8_t { kCartesian, kCoreXy, kDelta };

  /// Of a delta, Marlin's example configuration.
  static constexpr double kRod = 250;              ///< From a carriage to the effector.
  static constexpr double kRadius = 124;           ///< From the middle to a tower's joint.
  static constexpr double kPiecesPerSecond = 200;  ///< Moves across the bed are cut into.

  Kinematics() = default;
  explicit Kinematics(Kind kind) : kind_(kind) {}
  /// "cartesian", "corexy", "delta".
  [[nodiscard]] static std::optional<Kinematics> named(std::string_view name);

  /// Where the motors are when the nozzle is at `nozzle`. \pre A delta reaches it.
  [[nodiscard]] Axes motors(const Axes& nozzle) const;

  /// What a corner is measured by, for moves along these: a unit vector.
  [[nodiscard]] Axes corner_direction(const Axes& nozzle, const Axes& motors) const;

  /// Into how many pieces a move from `from` to `to` at `speed` mm/s is cut.
  [[nodiscard]] int pieces(const Axes& from, const Axes& to, double speed) const;

  /// The nearest place to `place` within the soft endstops of a machine of size `volume`: a box
  /// with its corner at 0, of a delta a cylinder about 0.
  [[nodiscard]] Axes within(Axes place, const Vec3& volume) const;

  /// Lowest and highest coordinates of that.
  [[nodiscard]] Box3 reach(const Vec3& volume) const;

  /// Where homing ends: at 0, a delta at the top.
  [[nodiscard]] Vec3 home(const Vec3& volume) const;
  /// A delta homes all axes, whatever it is asked.
  [[nodiscard]] bool homes_all() const { return kind_ == Kind::kDelta; }

  /// How M114 names the motors.
  [[nodiscard]] std::string_view motor_names() const;

 private:
  Kind kind_ = Kind::kCartesian;
};

}  // namespace slipstick
